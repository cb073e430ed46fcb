"""Writes the words of a JSON Schema as a dictionary of libFuzzer: names of keys, and the values that a key may have.

usage: key_dictionary.py SCHEMA DICTIONARY
"""

import json
import sys


def words(schema):
    if isinstance(schema, list):
        for item in schema:
            yield from words(item)
    elif isinstance(schema, dict):
        yield from schema.get("properties", {})
        yield from (value for value in schema.get("enum", []) if isinstance(value, str))
        if isinstance(schema.get("const"), str):
            yield schema["const"]
        for inner in schema.values():
            yield from words(inner)


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        found = sorted(set(words(json.load(file))))
    if not found:
        sys.exit(f"{sys.argv[1]}: no key found")
    with open(sys.argv[2], "w", encoding="utf-8") as file:
        file.writelines(f'"{word}"\n' for word in found)


if __name__ == "__main__":
    main()
