"""Formulas of pages, which are text there, as MathML for the site: it is read without network.

A formula is an indented block of a page of doc/theory.  Its language: letters are symbols, words
of several letters are text, _x, _{xy} and ^(x) are scripts as Unicode's are, <= >= -> => ||
signs.  Columns that two or more spaces divide stay columns.
"""
import html
import re

SUB = dict(zip("₀₁₂₃₄₅₆₇₈₉ₙᵢⱼₖ₋₊", "0123456789nijk-+"))
SUPER = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺ᵖ", "0123456789-+p"))
SIGNS = {"<=": "≤", ">=": "≥", "=>": "⇒", "->": "→", "-": "−", "<-": "←", "<": "⟨", ">": "⟩"}  # between blanks < and > compare
# Longest first; a name is a letter with accents, digits of scripts are none.
TOKEN = re.compile(r"""\s+ | \[P[^\]]*\] | \[[^\]]*\]\([^)]*\) | <= | >= | => | -> | <-(?=\s)
    | \d+(?:\.\d+)?(?:e-?\d+)? | [A-Za-zα-ωΑ-Ω]+ | [₀-₉ₙᵢⱼₖ₋₊]+ | [⁰¹²³⁴-⁹⁻⁺ᵖ]+ | [_^] | .""", re.X)
FUNCTIONS = {"sin", "cos", "log", "ln", "exp", "min", "max", "div", "arg", "diag", "Re", "Im", "grad",
             "sqrt", "tr", "conj", "sign"}
SPACE = "&#160;"  # MathML drops blanks
SHORT = {"in", "on", "of", "as", "by", "it", "at", "so", "or", "is"}  # words all the same


def tag(name, text, **attributes):
    return "<%s%s>%s</%s>" % (name, "".join(' %s="%s"' % pair for pair in attributes.items()), text,
                              name)


def atom(token):
    if token in SIGNS:
        return tag("mo", html.escape(SIGNS[token]))
    if re.match(r"\d", token):
        return tag("mn", token)
    if token in FUNCTIONS:
        return tag("mi", token)
    if re.match(r"[A-Za-zα-ωΑ-Ω]", token):
        if len(token) < 3 and token not in SHORT:
            return "".join(tag("mi", letter) for letter in token)
        return tag("mtext", SPACE + token + SPACE)
    return tag("mo", html.escape(token), **({"stretchy": "false"} if token in "|()[]{}" else {}))


def script(tokens, k):
    """What follows _ or ^ at k, and where it ends: one token, or what brackets enclose."""
    if k >= len(tokens):
        return "", k
    if tokens[k] not in "({":
        sign = tokens[k] in "-+" and k + 1 < len(tokens)
        end = k + 1 + sign
        return row(tokens[k:end]), end
    end, depth = k, 0
    while end < len(tokens):
        depth += {"(": 1, "{": 1, ")": -1, "}": -1}.get(tokens[end], 0)
        end += 1
        if depth == 0:
            break
    return row(tokens[k + 1:end - 1]), end


def row(tokens):
    """MathML of tokens; scripts belong to what stands before them."""
    done, k = [], 0
    while k < len(tokens):
        token, below, above = tokens[k], "", ""
        k += 1
        if token.isspace():
            continue
        if token[0] == "[" and len(token) > 1:
            done.append(tag("mtext", html.escape(token)))
            continue
        alone = tokens[k - 2:k - 1] == [" "] and tokens[k:k + 1] == [" "]
        base = tag("mo", html.escape(token)) if alone and token in "<>" else atom(token)
        while k < len(tokens):
            first = tokens[k][0]
            if first == "_":
                below, k = script(tokens, k + 1)
            elif first == "^":
                above, k = script(tokens, k + 1)
            elif first in SUB:
                below, k = below + row([SUB[sign] for sign in tokens[k]]), k + 1
            elif first in SUPER:
                above, k = above + row([SUPER[sign] for sign in tokens[k]]), k + 1
            elif first == "'" and not token[0].isdigit():
                above, k = above + tag("mo", "′"), k + 1
            else:
                break
        if not (below or above):
            if base.startswith("<mtext>" + SPACE) and done and done[-1].endswith(SPACE + "</mtext>"):
                base = done.pop().removesuffix(SPACE + "</mtext>") + base.removeprefix("<mtext>")
            done.append(base)
            continue
        kind = "m" + "sub" * bool(below) + "sup" * bool(above)
        done.append(tag(kind, "".join(tag("mrow", part) for part in (base, below, above) if part)))
    return "".join(done)


def block(lines):
    """A table of MathML: a row for each line, columns where two or more spaces stand."""
    cells = [re.split(r"\s{2,}", line.strip()) for line in lines]
    rows = [tag("mtr", "".join(tag("mtd", row(TOKEN.findall(cell)), style="text-align: left")
                               for cell in line)) for line in cells]
    return '<div class="formula">%s</div>' % tag(
        "math", tag("mtable", "".join(rows), columnalign="left"), display="block")


def with_formulas(text):
    """A page with its indented blocks as MathML."""
    def replaced(match):
        return block(match.group(0).rstrip("\n").split("\n")) + "\n"

    return re.sub(r"(?m)(?<=\n\n)(?:    (?![-*] ).+\n)+", replaced, text)
