// How a text becomes words. A formula and a question about it meet here: `\cos\alpha_1`, "cos α₁" and
// "cosine of alpha 1" give the same words; so do "0.022" and ".022", "pseudo-inverse" and "pseudoinverse".
"use strict";
window.WORDS = (() => {
  const GREEK = Object.fromEntries(
    ("α alpha β beta γ gamma δ delta ε epsilon ϵ epsilon ζ zeta η eta θ theta ϑ theta ι iota κ kappa λ lambda μ mu " +
      "µ mu ν nu ξ xi π pi ρ rho σ sigma τ tau υ upsilon φ phi ϕ phi χ chi ψ psi ω omega Γ gamma Δ delta Θ theta " +
      "Λ lambda Ξ xi Π pi Σ sigma Φ phi Ψ psi Ω omega").split(" ").reduce(
      (pairs, word, i, all) => (i % 2 ? [...pairs, [all[i - 1], word]] : pairs), []));
  const NAMES = [...new Set(Object.values(GREEK))].join("|");
  const SUBSCRIPT = /[₀-₉]+(?:,[₀-₉]+)*/g;
  const MARKS = { "\u0307": "dot", "\u0302": "hat", "\u0303": "tilde", "\u0304": "bar" };
  const SIGNS = { "√": "root", "∫": "integral", "∑": "sum", "×": "cross", "°": "", "⁻¹": "inverse", "²": "squared" };
  // One name for what has several: of functions, of signs, of places; British spelling.
  const SAME = {
    cosine: "cos", sine: "sin", tangent: "tan", atan: "arctan", arctangent: "arctan", sqrt: "root", det: "determinant",
    int: "integral", inv: "inverse", invert: "inverse", inverted: "inverse", equation: "eq", equations: "eq", eqs: "eq", table: "tab",
    figure: "fig", section: "sec", sect: "sec", chapter: "sec", appendix: "app", degree: "", degrees: "", deg: "",
    center: "centre", radii: "radius", axes: "axis", matrices: "matrix", square: "squared", circular: "circle", angular: "angle",
    rotational: "rotation", translational: "translation", setup: "set up",
  };
  const ENDINGS = [[/ies$/, "y"], [/(?<=[a-z]{2}[^sui])s$/, ""], [/ency$/, "ent"], [/ance$/, "ant"]];
  const stem = (word) => ENDINGS.reduce((stem, [ending, instead]) => stem.replace(ending, instead), word);
  const known = (word) => SAME[word] ?? SAME[stem(word)] ?? stem(word);

  // "α₁" -> "alpha_1", "φ̇" -> "phi_dot"; the commands and braces of LaTeX fall away.
  const spell = (text) => {
    let s = text.replace(/\\(?:left|right|mathbf|mathrm|boldsymbol|text|displaystyle)\b/g, " ");
    s = s.replace(/\\d?frac/g, " ").replace(/\^\{?-1\}?/g, "⁻¹").replace(/\^\{?2\}?(?!\d)/g, "²").replace(/\^\{?\\circ\}?/g, "°");
    s = s.replace(/\\(dot|hat|tilde|bar)\s*\{?\\?([A-Za-z]+)\}?/g, " $2_$1").replace(/([_^])\{([^{}]*)\}/g, "$1$2");
    s = s.replace(SUBSCRIPT, (found) => "_" + found.normalize("NFKC"));
    s = s.normalize("NFD").replace(/[\u0302-\u0304\u0307]/g, (mark) => "_" + MARKS[mark]);
    s = s.replace(/(sin|cos|tan)⁻¹/g, " arc$1 ").replace(/⁻¹|[√∫∑×°²]/g, (sign) => ` ${SIGNS[sign]} `).replace(/./gu, (c) => (GREEK[c] ? ` ${GREEK[c]}` : c));
    s = s.toLowerCase().replace(/pseudo-?(?=inverse)/g, "pseudo ").replace(new RegExp(`\\b(${NAMES})(?=[a-z0-9])`, "g"), "$1 ");
    return s.replace(/[\\{}$]/g, " ");
  };

  // Symbols keep their index ("alpha_1"), and count by their letter, too.
  const words = (text) => {
    const found = [];
    for (const raw of spell(text).match(/\d*\.?\d+|[a-z]+(?:_[a-z0-9,]+)*/g) || []) {
      if (/^[\d.]/.test(raw)) found.push(String(Number(raw)));
      else if (raw.includes("_")) found.push(raw, known(raw.split("_")[0]));
      else found.push(...known(raw).split(" "));
    }
    return found.filter(Boolean);
  };

  // In a question an index may be spoken: "alpha 1", "V x", "N_1"; "phi dot".
  const asked = (text) => {
    const letter = `(?:${NAMES}|\\b[a-z])`;
    const spoken = new RegExp(`\\b(${letter}) (\\d|[a-z]|dot|hat|tilde|bar)\\b(?!_)`, "g");
    return words(spell(text).replace(/(^|\s)([a-z]+)(\d)(?=\s|$)/g, "$1$2 $3").replace(spoken, "$1_$2"));
  };

  // A place, as people write it: `eq:6[2,3]`, "Eq. (16)", "Table 4", "A.2", "eq 5-2", "(16)".
  const OBJECTS = "eqs?|eqns?|equations?|tab|tables?|figs?|figures?|sect?|sections?|chapters?|app|appendix";
  const NUMBER = "[a-z][.,]?\\d+|\\d+(?:[-.]\\d+)*[a-z]?|[a-e](?![a-z])";
  const NAMED = new RegExp(`\\b(${OBJECTS})[.:]?\\s*\\(?(${NUMBER})\\)?((?:#\\d)?(?:\\/[\\w-]+)?(?:\\[[\\w,]+\\])?)`, "i");
  const BARE = /(?:^|\s)(?:\((\w[.,]?\d*(?:-\d+)?)\)|([A-E][.,]\d+|\d+-\d+))(?=\s|$)/i;
  const number = (text) => text.toLowerCase().replace(",", ".").replace(/^([a-z])(\d)/, "$1.$2");

  const place = (text) => {
    const named = NAMED.exec(text);
    if (named) {
      const object = known(named[1].toLowerCase().replace(/^eqns?$/, "eq"));
      return { object, number: number(named[2]), inside: named[3], rest: text.replace(named[0], " ") };
    }
    const bare = BARE.exec(text);
    return bare && { object: "eq", number: number(bare[1] || bare[2]), inside: "", rest: text.replace(bare[0], " ") };
  };

  return { words, asked, place, number };
})();
