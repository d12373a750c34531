#!/usr/bin/env python3
"""The table of the searches, in Markdown, from what snug_search_quality prints.
Usage: search_table.py FILE.json"""
import json
import sys


def table(rows):
    times = [at["seconds"] for at in rows[0]["snug"]]
    head = ["object", "start", "greedy"] + [f"{seconds:g} s" for seconds in times] + ["least"]
    lines = ["| " + " | ".join(head) + " |", "|---|" + "---:|" * (len(head) - 1)]
    for row in rows:
        cells = [row["object"], str(row["start"]), str(row["greedy"])]
        cells += [f'{at["median"]} (+{at["above_least_percent"]:.1f} %)' for at in row["snug"]]
        lines.append("| " + " | ".join(cells + [str(row["least"])]) + " |")
    return "\n".join(lines)


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        print(table(json.load(file)))


if __name__ == "__main__":
    main()
