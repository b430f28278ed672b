// Which places of the report answer a question, best first. Words count by where they stand and by how rare
// they are (BM25 with weighted fields); a place that is named comes first; what is wrong comes before what is
// right, and a fault before what follows from it.
"use strict";
window.RANK = (() => {
  const { words, asked, place, number } = window.WORDS;
  // What a correction changes is what a claim is about; then what stands left of the sign "=".
  const WEIGHTS = { title: 3, changed: 4, subject: 3, printed: 2, correct: 2, note: 2, about: 5, symbols: 1, paper: 1 };
  const SATURATION = 1.2, LENGTH = 0.6, PREFIX = 0.6;
  const PHRASE = 1.5, ABOUT = 1.5, ALL = 2.5; // the words stand together; are what is wrong, or its name; are all of a field
  const REACH = { motion: 1.8, number: 1.6, text: 1.15 };
  const DOUBT = { conditional: 0.85, editorial: 0.85, uncheckable: 0.7 }; // false before unsaid, before what nothing decides
  const FOLLOWING = 0.75; // where another fault explains this one
  const FAINT = 0.05; // of the best points: what shares but "of" and "the" with a question
  const NAMED = 1e3, EXACT = 1e5;

  const anchor = (id) => id.replace(/[^A-Za-z0-9_]+/g, "-").replace(/^-|-$/g, "");
  const without = (all, some) => {
    const rest = [...some];
    return all.filter((word) => {
      const at = rest.indexOf(word);
      if (at >= 0) rest.splice(at, 1);
      return at < 0;
    });
  };

  // Records of all places, with their words by field.
  const claim = (paper, { columns, verdicts }, row) => {
    const r = Object.fromEntries(columns.map((name, i) => [name, row[i] ?? ""]));
    r.verdict = verdicts[r.verdict][0];
    if (typeof r.note === "number") r.note = paper.notes[r.note];
    const [printed, correct] = [words(r.printed), words(r.correct)];
    const fields = {
      title: words(`${r.place} ${r.id.split(/[/[]/).slice(1).join(" ").replaceAll("-", " ")}`),
      changed: r.correct ? [...without(correct, printed), ...without(printed, correct)] : [],
      subject: r.printed.includes("=") ? words(r.printed.split("=")[0]) : [],
      printed, correct, note: words(r.note),
      symbols: (r.symbols || []).flatMap((i) => words(paper.symbols[i])), paper: words(paper.key.replaceAll("-", " ")),
    };
    return { ...r, kind: "claim", paper: paper.key, address: `${paper.key}.html#${anchor(r.id)}`, fields };
  };

  const whole = (paper, [id, place, verdict, rows, title, why]) => ({
    kind: "whole", paper: paper.key, id, place: title ? `${place}: ${title}` : place, verdict, follows: "", note: why || rows,
    address: `${paper.key}.html#${anchor(id)}`,
    fields: { title: words(place), about: words(title), note: words(why), paper: words(paper.key.replaceAll("-", " ")) },
  });

  // An equation reaches as far as its gravest part; one of a single row is one place, and has the words of both.
  const joined = (wholes, rows) =>
    wholes.filter((whole) => {
      const parts = rows.filter((row) => row.id.split(/[/[]/)[0] === whole.id);
      whole.reach = Object.keys(REACH).find((reach) => parts.some((row) => row.reach === reach && !row.follows));
      const same = parts.find((row) => row.id === whole.id);
      if (same) same.fields.about = [...whole.fields.about, ...whole.fields.note];
      return !same;
    });

  const other = ([kind, address, title, text]) => ({
    kind, address, id: "", place: title, note: text, follows: "", fields: { title: words(`${kind} ${title}`), note: words(text) },
  });

  const gather = (claims, places) => [
    ...claims.papers.flatMap((paper) => {
      const rows = paper.rows.map((row) => claim(paper, claims, row));
      return [...joined(paper.wholes.map((each) => whole(paper, each)), rows), ...rows];
    }),
    ...places.map(other),
  ];

  // Word -> [place, weight of its occurrences] pairs; long texts count less.
  const invert = (records) => {
    const size = (r) => Object.values(r.fields).reduce((sum, field) => sum + field.length, 0);
    const mean = records.reduce((sum, r) => sum + size(r), 0) / records.length;
    const index = new Map();
    records.forEach((record, i) => {
      const share = 1 - LENGTH + (LENGTH * size(record)) / mean;
      const counts = new Map();
      for (const [name, field] of Object.entries(record.fields))
        for (const word of field) counts.set(word, (counts.get(word) || 0) + WEIGHTS[name] / share);
      for (const [word, count] of counts) {
        if (!index.has(word)) index.set(word, []);
        index.get(word).push([i, count]);
      }
    });
    return index;
  };

  const rarity = (found, all) => Math.log(1 + (all - found + 0.5) / (found + 0.5));

  // Points of each place for a list of words; how much of the question it answers counts twice.
  const points = (question, index, all) => {
    const sums = new Map();
    let asked = 0;
    for (const word of new Set(question)) {
      const begins = word.length > 2 && /^[a-z]+$/.test(word);
      const forms = [...index.keys()].filter((known) => known === word || (begins && known.startsWith(word)));
      const best = new Map();
      for (const form of forms)
        for (const [i, count] of index.get(form)) {
          const value = (count / (count + SATURATION)) * (form === word ? 1 : PREFIX);
          best.set(i, Math.max(best.get(i) || 0, value));
        }
      const rare = rarity(best.size, all);
      asked += rare;
      for (const [i, value] of best) {
        const [points, answered] = sums.get(i) || [0, 0];
        sums.set(i, [points + rare * value, answered + rare]);
      }
    }
    return new Map([...sums].map(([i, [points, answered]]) => [i, points * (answered / asked) ** 2]));
  };

  const SMALL = new Set(["of", "the"]);
  const line = (list) => ` ${list.filter((word) => !SMALL.has(word)).join(" ")} `;

  // By how much more a record is worth than its words one by one.
  const together = (record, question) => {
    const asked = line(question);
    const fields = Object.entries(record.fields).map(([name, field]) => [name, line(field)]);
    const whole = fields.filter(([name, field]) => name !== "paper" && field === asked).length;
    const phrase = asked.trim().includes(" ") && fields.some(([, field]) => field.includes(asked));
    const about = record.fields.changed?.length && question.every((word) => record.fields.changed.includes(word));
    const called = question.every((word) => SMALL.has(word) || record.fields.about?.includes(word));
    return ALL ** Math.min(whole, 2) * (phrase ? PHRASE : 1) * (about || called ? ABOUT : 1);
  };

  const prior = (record) =>
    (record.verdict === "verified" ? 1 : REACH[record.reach] || 1) * (DOUBT[record.verdict] || 1) * (record.follows ? FOLLOWING : 1);

  // Whether a record is in the place that the question names, and how exactly.
  const named = (record, spot) => {
    const parts = /^(\w+):([^#/[]+)/.exec(record.id);
    if (!parts || parts[1] !== spot.object || number(parts[2]) !== spot.number) return 0;
    return spot.inside && record.id.endsWith(spot.inside) ? EXACT : NAMED;
  };

  // Equations with the gravest fault first; of one, the whole, then its faults; what is right comes last.
  const ranked = (records, spot) => {
    const key = (record) => `${record.paper} ${record.id.split(/[/[]/)[0]}`;
    const inside = records.map((record) => named(record, spot));
    const gravest = new Map();
    records.forEach((record, i) => inside[i] && gravest.set(key(record), Math.max(gravest.get(key(record)) || 0, prior(record))));
    return records.map((record, i) => {
      const first = record.kind === "whole" && !record.id.includes("/") ? 2 : prior(record) > 1 ? 1 : 0;
      return inside[i] && inside[i] * (first ? gravest.get(key(record)) + first / 100 : 0.1 * gravest.get(key(record)));
    });
  };

  // A fault stands before what follows from it.
  const inOrder = (hits) => {
    const best = new Map();
    for (const { record, score } of hits) {
      if (!record.follows) continue;
      const key = `${record.paper} ${record.follows}`;
      best.set(key, Math.max(best.get(key) || 0, score));
    }
    const raised = ({ record, score }) => Math.max(score, (1 + 1e-9) * (best.get(`${record.paper} ${record.id}`) || 0));
    return hits.map((hit) => ({ ...hit, score: raised(hit) })).sort((a, b) => b.score - a.score);
  };

  const search = (records, index, text) => {
    const spot = place(text);
    const question = asked(spot?.rest.trim() ? spot.rest : text);
    const scored = points(question, index, records.length);
    const exact = (record) => (record.id && anchor(text.trim()) === anchor(record.id) ? EXACT : 0);
    const places = spot ? ranked(records, spot) : records.map(exact);
    const hits = records.map((record, i) => {
      const found = (scored.get(i) || 0) * together(record, question) * prior(record);
      return { record, found, place: places[i], score: places[i] * (spot?.rest.trim() && found ? 10 : 1) + found };
    });
    const best = Math.max(...hits.map(({ found }) => found));
    return inOrder(hits.filter(({ found, place }) => place || found > FAINT * best));
  };

  return { gather, invert, search };
})();
