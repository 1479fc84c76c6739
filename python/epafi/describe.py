"""What `epafi help --format json` says of commands and keys, for man, bash, editors and readers.

    python3 describe.py DESCRIPTION.json SHARE    writes the files below the folder SHARE
"""
from __future__ import annotations

import json
import os
import sys
import xml.etree.ElementTree as xml
from typing import Any, Iterable, Mapping, Optional

Key = Mapping[str, Any]
# What bash completes a value to, by the beginning of its name.
OFFERED = {
    "SCENE": """compgen -f -X '!*.@(xml|yaml|yml)' -- "$word"; compgen -d -- "$word\"""",
    "DIR": 'compgen -d -- "$word"',
    "FILE": 'compgen -f -- "$word"'}
OFFERED["STUDY"] = OFFERED["SCENE"]
WORDS = """compgen -W '%s' -- "$word\""""
# What a value may be: types in XML, and in JSON.  A text in place of a number is an expression in
# constants.
TYPES: dict[str, tuple[str, Any]] = {
    "double": ("double int string", ["number", "string"]),
    "int": ("int string", ["integer", "string"]),
    "bool": ("bool", "boolean"),
    "string": ("string", "string"),
    "string: expression": ("string double int", ["string", "number"]),
    "Array(string)": ("Array(string)", "array string"),
    "Array(int)": ("Array(int) int Array(string) string", ["integer", "string"]),
    "Array(double)": ("Array(double) Array(int) double int Array(string) string",
                                        ["number", "string"]),
    "TwoDArray(double)": ("TwoDArray(double) TwoDArray(int) TwoDArray(string)", None)}


def roff(text: str) -> str:
    """A hyphen is a minus sign, a line does not begin with a control character."""
    text = text.replace("\\", "\\\\").replace("-", "\\-")
    return "\\&" + text if text[:1] in (".", "'") else text


def man_page(epafi: Mapping[str, Any]) -> str:
    lines = [".TH EPAFI 1", ".SH NAME", "epafi \\- " + epafi["title"], ".SH SYNOPSIS"]
    for command in epafi["commands"]:
        lines += [".B " + roff(command["usage"]), ".br"]
    lines.append(".SH COMMANDS")
    for command in epafi["commands"]:
        lines += [".SS " + roff(command["usage"]), roff(command["purpose"]) + "."]
        for option in command["options"]:
            lines += [".TP", ".B " + roff((option["name"] + " " + option["value"]).strip()),
                      roff(option["meaning"])]
    lines.append(".SH EXIT STATUS")
    for code in epafi["exit codes"]:
        lines += [".TP", ".B " + code["code"], roff(code["meaning"])]
    return "\n".join(lines) + r"""
.SH FILES
A run writes a folder, ./<scene>.out unless \-\-output says otherwise:
history.csv, contact.csv, boundary.csv, interior.csv, solution.hdf, used.xml,
timings.txt; a study study.csv.
"""


def completion(epafi: Mapping[str, Any]) -> str:
    def offered(value: str, words: Iterable[str] = ()) -> str:
        text = WORDS % " ".join(words) if words else OFFERED.get(value.partition(".")[0])
        return "mapfile -t COMPREPLY < <(%s)" % text if text else "COMPREPLY=()"

    names = [command["name"] for command in epafi["commands"]]
    lines = ["# bash completion of epafi; written by `epafi help --format bash`.",
             "shopt -s extglob", "_epafi() {",
             "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}",
             "  if ((COMP_CWORD == 1)); then",
             "    " + offered("", names + ["--help"]),
             "    return", "  fi", "  case ${COMP_WORDS[1]} in"]
    for command in epafi["commands"]:
        lines.append("    %s)" % command["name"])
        for option in command["options"]:
            if option["value"]:
                lines.append("      [[ $before == %s ]] && { %s; return; }" % (
                    option["name"], offered(option["value"], option["words"])))
        options = [option["name"] for option in command["options"]] + ["--help"]
        lines += ["      if [[ $word == -* ]]; then",
                  "        " + offered("", options),
                  "      else", "        " + offered(command["argument"]), "      fi", "      ;;"]
    return "\n".join(lines + ["  esac", "}", "complete -o filenames -F _epafi epafi", ""])


def is_list(key: Key) -> bool:
    return key["type"] == "ParameterList"


def name_of(key: Key) -> str:
    return key["path"].rpartition("->")[2]


def children(keys: Iterable[Key], parent: str) -> list[Key]:
    return [key for key in keys if key["path"].rpartition("->")[0] == parent]


def pattern(name: str) -> Optional[str]:
    """A regular expression for <body> and Hole <k>; None: the name is literal."""
    if name.startswith("<"):
        return ".+"
    return name.replace("<k>", "[1-9][0-9]*") if "<k>" in name else None


def markdown(grammar: str, keys: list[Key]) -> str:
    """One table per list."""
    def plain(text: str) -> str:
        for sign, replacement in ("|", "\\|"), ("<", "&lt;"), (">", "&gt;"), ("*", "\\*"):
            text = text.replace(sign, replacement)
        return text

    def meaning(key: Key) -> str:
        return key["meaning"] + ("; " + key["only"] if key["only"] else "")

    lines = ["# Parameters of a " + grammar, "",
             "Written by `epafi parameters --format markdown`.  `<body>` and the like stand for "
             "names of your choice,", "`<k>` for 1, 2, ..."]
    for above in [None] + [key for key in keys if is_list(key) and not key["free"]]:
        lines += ["", "## " + (plain(above["path"]) if above else "The " + grammar)]
        if above:
            lines += ["", plain(meaning(above))]
        lines += ["", "| key | type | default | range | meaning | unit |",
                  "|---|---|---|---|---|---|"]
        for key in children(keys, above["path"] if above else ""):
            lines.append("| %s | %s | %s | %s | %s | %s |" % (
                plain(name_of(key)), key["type"], plain(key["default"]), plain(key["range"]),
                plain(meaning(key)), key["unit"]))
    return "\n".join(lines) + "\n"


def documented(key: Key) -> str:
    return key["meaning"] + (" [%s]" % key["unit"] if key["unit"] else "")


def sample_list(keys: list[Key]) -> str:
    """A list that Teuchos can read: every key, with its default or a sample value."""
    def sample(key: Key) -> str:
        if key["default"] not in ("none", "required"):
            return str(key["default"])
        if not key["allowed"]:
            return str(key["sample"])
        return ("{%s}" if key["type"].startswith("Array") else "%s") % key["allowed"][0]

    def fill(parent: xml.Element, path: str) -> None:
        for key in children(keys, path):
            told = [documented(key), key["only"], key["range"],
                    "" if is_list(key) else "default: " + key["default"]]
            parent.append(xml.Comment(" %s " % "; ".join(text for text in told if text)))
            if is_list(key):
                fill(node(parent, "ParameterList", name=name_of(key)), key["path"])
            else:
                node(parent, "Parameter", name=name_of(key), type=key["type"].split(":")[0],
                     value=sample(key))

    top = xml.Element("ParameterList", {"name": "Parameters"})
    fill(top, "")
    xml.indent(top)
    return xml.tostring(top, encoding="unicode") + "\n"


def json_object(keys: list[Key], parent: str = "") -> dict[str, Any]:
    """What a list holds; keys that depend on others (a law's, a condition's) side by side."""
    rules: dict[str, Any] = {"type": "object", "additionalProperties": False}
    required = [name_of(key) for key in children(keys, parent)
                if key["required"] and not key["only"]]
    if required:
        rules["required"] = required
    for key in children(keys, parent):
        name = pattern(name_of(key))
        group = rules.setdefault("patternProperties" if name else "properties", {})
        group["^%s$" % name if name else name_of(key)] = {
            "description": documented(key), **json_value(keys, key)}
    return rules


def json_value(keys: list[Key], key: Key) -> dict[str, Any]:
    if is_list(key):
        return {"type": "object"} if key["free"] else json_object(keys, key["path"])
    words = {"enum": key["allowed"]} if key["allowed"] else {}
    type_ = TYPES[key["type"]][1]
    if key["type"] == "TwoDArray(double)":
        pair = {"type": "array", "minItems": 2, "maxItems": 2,
                "items": {"type": ["number", "string"]}}
        return {"type": "array", "items": pair}
    if key["type"] == "Array(string)":
        return {"type": "array", "items": {"type": "string", **words}}
    if key["type"].startswith("Array"):
        return {"type": ["array", *type_], "items": {"type": type_, **key["limits"]},
                **key["limits"]}
    return {"type": type_, **key["limits"], **(words if type_ == "string" else {})}


def json_schema(grammars: Mapping[str, list[Key]]) -> str:
    """JSON Schema (draft 7) of the YAML files: names, types, words, ranges, and what is required
    whatever other keys say."""
    objects: list[dict[str, Any]] = [
        {"title": "a " + name, **json_object(keys)} for name, keys in grammars.items()]
    return json.dumps({
        "$schema": "http://json-schema.org/draft-07/schema#", "title": "Epafi",
        "$comment": "names, types, words and ranges; what depends on other keys, and what is "
                    "required because of them, `epafi check` knows",
        "type": "object", "minProperties": 1, "maxProperties": 1,
        # alone: editors then say what is wrong where
        "additionalProperties": objects[0] if len(objects) == 1 else {"anyOf": objects},
    }, indent=1, ensure_ascii=False) + "\n"


def node(parent: xml.Element, tag: str, text: str = "", **attributes: str) -> xml.Element:
    child = xml.SubElement(parent, tag, attributes)
    child.text = text or None
    return child


def marks(parent: xml.Element) -> None:
    node(parent, "ref", name="marks")


def rng_list(parent: xml.Element, keys: list[Key], path: str = "") -> None:
    """Keys in any order.  RELAX NG cannot say "each at most once" of elements that differ in an
    attribute only."""
    choice = node(node(parent, "zeroOrMore"), "choice")
    for key in children(keys, path):
        entry = node(choice, "element", name="ParameterList" if is_list(key) else "Parameter")
        node(entry, "a:documentation", documented(key))
        name = node(entry, "attribute", name="name")
        form = pattern(name_of(key))
        if form is None:
            node(name, "value", name_of(key))
        elif form == ".+":
            node(name, "text")
        else:
            node(node(name, "data", type="string"), "param", form, name="pattern")
        marks(entry)
        if key["free"]:
            node(entry, "ref", name="anything")
        elif is_list(key):
            rng_list(entry, keys, key["path"])
        else:
            rng_value(entry, key)


def rng_types(parent: xml.Element, types: list[str]) -> None:
    choice = node(node(parent, "attribute", name="type"), "choice")
    for type_ in types:
        node(choice, "value", type_)


def rng_value(entry: xml.Element, key: Key) -> None:
    if key["type"] in ("double", "int"):
        ways = node(entry, "choice")
        number, text = node(ways, "group"), node(ways, "group")
        rng_types(number, TYPES[key["type"]][0].split()[:-1])
        value = node(number, "attribute", name="value")
        data = node(value, "data", type="integer" if key["type"] == "int" else "double")
        for limit, bound in key["limits"].items():
            name = {"minimum": "minInclusive", "maximum": "maxInclusive",
                    "exclusiveMinimum": "minExclusive", "exclusiveMaximum": "maxExclusive"}
            node(data, "param", "%.15g" % bound, name=name[limit])
        rng_types(text, ["string"])
        node(node(text, "attribute", name="value"), "text")
        return
    rng_types(entry, TYPES[key["type"]][0].split())
    value = node(entry, "attribute", name="value")
    if key["type"] == "bool" or key["type"] == "string" and key["allowed"]:
        words = node(value, "choice")
        for word in key["allowed"] or ("true", "false"):
            node(words, "value", word)
    else:  # entries of arrays stand in one text
        node(value, "text")


def relax_ng(grammars: Mapping[str, list[Key]]) -> str:
    """RELAX NG of the XML files: only it can tell elements of one name by an attribute's value."""
    top = xml.Element("grammar", {
        "xmlns": "http://relaxng.org/ns/structure/1.0",
        "xmlns:a": "http://relaxng.org/ns/compatibility/annotations/1.0",
        "datatypeLibrary": "http://www.w3.org/2001/XMLSchema-datatypes"})
    node(top, "a:documentation", "Names, types, words and ranges; what is required, given twice, or "
         "depends on other keys, `epafi check` knows.")
    start = node(node(top, "start"), "choice")
    for name, keys in grammars.items():
        node(start, "ref", name=name)
        root = node(node(top, "define", name=name), "element", name="ParameterList")
        node(node(root, "optional"), "attribute", name="name")
        marks(root)
        rng_list(root, keys)
    define = node(top, "define", name="marks")
    for mark in "id", "docString", "isDefault", "isUsed":
        node(node(define, "optional"), "attribute", name=mark)
    free = node(node(node(top, "define", name="anything"), "zeroOrMore"), "choice")
    for element, attributes in (("Parameter", ("name", "type", "value")),
                                ("ParameterList", ("name",))):
        entry = node(free, "element", name=element)
        for attribute in attributes:
            node(entry, "attribute", name=attribute)
        marks(entry)
        if element == "ParameterList":
            node(entry, "ref", name="anything")
    xml.indent(top)
    return xml.tostring(top, encoding="unicode") + "\n"


def files(epafi: Mapping[str, Any]) -> dict[str, str]:
    """All files by their place below share/."""
    result = {"man/man1/epafi.1": man_page(epafi),
              "bash-completion/completions/epafi": completion(epafi)}
    for name, grammars in {"epafi": epafi["keys"],
                           **{name: {name: keys} for name, keys in epafi["keys"].items()}}.items():
        result["epafi/schema/%s.rng" % name] = relax_ng(grammars)
        result["epafi/schema/%s.json" % name] = json_schema(grammars)
    for name, keys in epafi["keys"].items():
        result["epafi/parameters/" + name + ".md"] = markdown(name, keys)
        result["epafi/parameters/" + name + ".xml"] = sample_list(keys)
    return result


def main(description: str, share: str) -> None:
    with open(description, encoding="utf-8") as stream:
        epafi = json.load(stream)
    for name, text in files(epafi).items():
        path = os.path.join(share, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(text)


if __name__ == "__main__":
    main(*sys.argv[1:])
