"""Every message that the sources make stands in the catalogue of words in both languages, with its values.

Usage: catalogue_test.py [unittest arguments]
"""

import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
SOURCES = [path for folder in ("snug", "cli", "wasm") for path in sorted((ROOT / folder).rglob("*"))
           if path.suffix in (".h", ".cpp") and (path.parent.name, path.suffix) != ("words", ".cpp")]
# What stands in Latin letters in Japanese, too.
KEPT = re.compile(r"""
    `[^`]*` | "[^"]*"                           # what is typed, and words of a file
    | --[a-z]+(-[a-z]+)*([ ](auto|plate|tiles|lego-brick))?
    | \b(en|ja|auto|none|across|all|null|true|false|stl|ply|x,y,z)\b  # values of options
    | \b(mm|mm3|cm3|cm|m|in|kPa|kg)\b
    | [\w-]*(/[\w-]*)*\.[a-z0-9]+\b | sponge/   # files and their kinds
    | \b(zip|gzip|meshopt|libharu|snug|build|model|property)\b
    """, re.VERBOSE)


def tokens(source):
    """Words and marks of C++ source; a string is ('string', its text), with those that follow it at once."""
    source = re.sub(r"//[^\n]*", lambda m: m.group() if '"' in m.group() else "", source)
    found = []
    for match in re.finditer(r'"((?:[^"\\\n]|\\.)*)"|\w+|[^\s\w]', source):
        if match.group(1) is None:
            found.append(match.group())
            continue
        text = match.group(1).replace('\\"', '"').replace("\\\\", "\\")
        if found and isinstance(found[-1], tuple):
            text = found.pop()[1] + text
        found.append(("string", text))
    return found


def catalogue():
    """Each row as code, English, Japanese."""
    for path in sorted((ROOT / "snug" / "words").glob("*.cpp")):
        text = path.read_text()
        found = tokens(text) if re.search(r"Wording kWordsOf\w+\[\]", text) else []
        for i in range(len(found) - 6):
            row = found[i:i + 7]
            if [t if isinstance(t, str) else "s" for t in row] == ["{", "s", ",", "s", ",", "s", "}"]:
                yield row[1][1], row[3][1], row[5][1]


def messages(found):
    """Each say(...) of a source as the codes that it may have and the names of its values."""
    open_calls, depth = [], 0
    for i, token in enumerate(found):
        if token in ("(", "{"):
            depth += 1
            if token == "(" and found[i - 1] == "say":
                open_calls.append({"depth": depth, "codes": [], "names": set(), "in_code": True})
        elif token in (")", "}"):
            if open_calls and open_calls[-1]["depth"] == depth:
                call = open_calls.pop()
                yield call["codes"], call["names"]
            depth -= 1
        elif open_calls:
            call = open_calls[-1]
            if token == "," and call["depth"] == depth:
                call["in_code"] = False
            elif isinstance(token, tuple) and call["in_code"] and call["depth"] == depth:
                call["codes"].append(token[1])
            elif isinstance(token, tuple) and found[i - 1] == "{" and found[i + 1] == ",":
                call["names"].add(token[1])


def shown(sentence):
    return set(re.findall(r"\{(\w+)[,;&/]?\}", sentence))


def choosing(sentence):
    return set(re.findall(r"\{(\w+)\|[^|{}]*\|[^|{}]*\}", sentence))


class Catalogue(unittest.TestCase):
    # in_both is for what brings its own wording in each language, as one value each.
    rows = [row for row in catalogue() if row[0] != "in_both"]
    sources = {path: tokens(path.read_text()) for path in SOURCES}

    def test_the_catalogue_was_read(self):
        self.assertGreater(len(self.rows), 100)
        self.assertGreater(sum(1 for found in self.sources.values() for _ in messages(found)), 100)

    def test_no_code_stands_twice(self):
        codes = [code for code, _, _ in self.rows]
        self.assertEqual(sorted(codes), sorted(set(codes)))

    def test_both_languages_show_the_same_values(self):
        for code, english, japanese in self.rows:
            for sentence in (english, japanese):
                places = re.findall(r"[{}]", re.sub(r"\{\w+([,;&/]?|\|[^|{}]*\|[^|{}]*)\}", "", sentence))
                self.assertEqual(places, [], f"{code}: {sentence}")
            self.assertEqual(shown(english), shown(japanese), code)

    def test_every_message_has_a_row_and_its_values(self):
        rows = {code: (english, japanese) for code, english, japanese in self.rows}
        for path, found in self.sources.items():
            for codes, names in messages(found):
                for code in codes:
                    if code == "in_both":
                        self.assertEqual(names, {"english", "japanese"}, path)
                        continue
                    self.assertIn(code, rows, path)
                    english, japanese = rows[code]
                    places = shown(english) | choosing(english) | choosing(japanese)
                    self.assertEqual(names, places, f"{path}: {code}")

    def test_every_row_is_used(self):
        used = {token[1] for found in self.sources.values() for token in found if isinstance(token, tuple)}
        self.assertEqual([code for code, _, _ in self.rows if code not in used], [])

    def test_japanese_is_japanese(self):
        for code, english, japanese in self.rows:
            words = re.findall(r"\w{2,}", KEPT.sub("", re.sub(r"\{[^{}]*\}", "", japanese)), re.ASCII)
            plain = [word for word in words if word.isalpha() and (word.islower() or word not in english)]
            self.assertEqual(plain, [], f"{code}: {japanese}")
            if re.search(r"[A-Za-z]{2,}", KEPT.sub("", re.sub(r"\{[^{}]*\}", "", english))):
                self.assertRegex(japanese, "[\u3040-\u30ff\u4e00-\u9fff]", code)


if __name__ == "__main__":
    unittest.main()
