"""The tables of arrangements, from what snug_arrange_times printed."""

PUBLISHED = {"swim": 78.30, "shirts": 89.72, "trousers": 91.79, "shapes0": 68.58, "albano": 89.46, "marques": 90.91}


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows])


def or_dash(value, form="{:.0f}"):
    return "–" if value is None else form.format(value)


def two_table(rows):
    return table(["items", "ways", "least of all, blocks", "found", "after, s"],
                 [[row["items"], row["ways"], row["least_blocks"], row["found_blocks"], f"{row['found_s']:.2f}"]
                  for row in rows])


def kits_table(rows):
    def over(row, key):
        return " / ".join("–" if seed[key] is None else f"{100 * seed[key]:.1f}" for seed in row["seeds"])
    return table(["items", "least known, blocks", "no less than", "over the least after 1 s, %", "after all, %", "shelves of boxes",
                  "libnest2d"],
                 [[row["items"], or_dash(row["least_blocks"]), or_dash(row["lower_bound_blocks"]),
                   over(row, "after_1_s_over_least"), over(row, "after_all_over_least"), row["shelves_blocks"],
                   or_dash(row["libnest2d_blocks"])] for row in rows])


def strips_table(rows):
    names = list(dict.fromkeys(row["instance"] for row in rows))
    lines = []
    for name in names:
        own = {row["cells"]: row for row in rows if row["instance"] == name and "cells" in row}
        peer = next((row for row in rows if row["instance"] == name and "libnest2d_usage" in row), {})
        best = max((row["usage"] for row in own.values() if row["usage"]), default=None)
        mean = PUBLISHED.get(name)
        lines.append([name] + [f"{or_dash(own[cells]['usage'], '{:.2f}')} ({100 * (1 - own[cells]['area_over_cells_area']):.1f})"
                               if cells in own else "–" for cells in (300, 1000)]
                     + [or_dash(peer.get("libnest2d_usage"), "{:.2f}"), or_dash(mean, "{:.2f}"),
                        or_dash(mean - best if mean and best else None, "{:.2f}")])
    return table(["instance", "usage at 1/300, % (lost to cells)", "at 1/1000, % (lost to cells)", "libnest2d", "sparrow, 20 min",
                  "distance"], lines)


def parts(report):
    """Headings, sentences and tables."""
    found = ["## Arranging several items"]
    if report.get("two"):
        found += ["Two bench objects each in blocks of 15 × 15 × 22 mm without walls, all quarter turns, beside the least of all "
                  "places of all ways; one second, one thread.", two_table(report["two"])]
    if report.get("kits"):
        found += ["Kits of bench objects in blocks of 15 mm with walls of 50 mm, one thread, three seeds; the least known is that "
                  "of these and of longer runs with two other seeds. Beside them shelves of bounding boxes, and libnest2d on "
                  "the masks' outlines.", kits_table(report["kits"])]
    if report.get("many"):
        many = report["many"]
        found += [f"{many['items']} items of {many['kinds']} kinds: a first answer after {or_dash(many['first_s'], '{:.1f}')} s, in the end "
                  f"{or_dash(many['blocks'])} blocks (no less than {many['lower_bound_blocks']:.0f}), {many['peak_mb']:.0f} MB at the peak."]
    if report.get("strips"):
        found += ["Strip packing (ESICUP), polygons grown to whole cells of the strip's height / 300 and / 1000, one thread and the "
                  "same time for each; libnest2d on the polygons themselves, with bisection of the length.",
                  strips_table(report["strips"])]
    return found
