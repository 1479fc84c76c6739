"""Formulas of the site: what the text means is what MathML says, and all of doc/theory is well formed.

    formulas.py ROOT
"""
import glob
import os
import re
import sys
import xml.etree.ElementTree as xml

sys.path.insert(0, os.path.join(sys.argv[1], "cmake"))
from claims import claim, finish  # noqa: E402
from formulas import block, with_formulas  # noqa: E402


def told(text):
    """A formula in a line: scripts in braces, columns divided by bars."""
    def of(node):
        inside = [of(child) for child in node]
        if node.tag in ("msub", "msup", "msubsup"):
            marks = {"msub": "_", "msup": "^", "msubsup": "_^"}[node.tag]
            return inside[0] + "".join("%s{%s}" % pair for pair in zip(marks, inside[1:]))
        joined = ("|" if node.tag == "mtr" else "").join(inside)
        return joined + (node.text or "").replace("\xa0", " ")
    return of(xml.fromstring(block([text])))


for text, meant in [
        ("    <S u, v>_C = f", "⟨Su,v⟩_{C}=f"), ("    |λ_t| <= s", "|λ_{t}|≤s"),
        ("    |λ_t| < s  =>  u_t = 0", "|λ_{t}|<s|⇒|u_{t}=0"), ("    a > 0", "a>0"),
        ("    (V+G)⁻¹ h^(p+1/2)", "(V+G)^{−1}h^{p+1/2}"), ("    K'ψ + B₀'λ", "K^{′}ψ+B_{0}^{′}λ"),
        ("    D_{ij} for all i", "D_{ij} for all i"), ("    r ← y - m φ'(p)", "r←y−mφ^{′}(p)")]:
    claim(told(text) == meant, "%s: %s" % (text.strip(), told(text)))
for page in sorted(glob.glob(os.path.join(sys.argv[1], "doc/theory/*.md"))):
    with open(page, encoding="utf-8") as stream:
        made = with_formulas(stream.read())
    for formula in re.findall(r'<div class="formula">.*?</div>', made):
        xml.fromstring(formula)  # raises
    claim("</math>" in made and not re.search(r"\n\n    (?![-*] )\S", made),
          "all formulas of %s are well formed" % os.path.basename(page))
finish()
