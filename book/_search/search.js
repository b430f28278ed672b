// The page of the search: hits for ?q=…, each with verdict, excerpt and address.
"use strict";
(() => {
  const MOST = 40, LONG = 220;
  const records = window.RANK.gather(window.CLAIMS, window.PLACES);
  const index = window.RANK.invert(records);
  const input = document.querySelector(".find input");
  const status = document.querySelector("#search [role=status]");
  const list = document.querySelector("ol.hits");

  const make = (tag, text, name = "") => Object.assign(document.createElement(tag), { textContent: text, className: name });
  const short = (text) => (text.length > LONG ? `${text.slice(0, LONG).replace(/\s+\S*$/, "")} …` : text);

  const badge = (verdict) => {
    const [, shape, word] = window.CLAIMS.verdicts.find(([name]) => name === verdict);
    return make("span", `${shape} ${word}`, `badge-verdict v-${verdict}`);
  };

  const item = (record) => {
    const hit = make("li", "", record.verdict ? `v-${record.verdict}` : "");
    const head = make("p", "", "head");
    const link = Object.assign(make("a", record.place || record.address), { href: record.address });
    head.append(link, record.verdict ? badge(record.verdict) : make("span", record.kind, "quiet"));
    const said = [record.printed, record.correct && `should be: ${record.correct}`].filter(Boolean).join("   →   ");
    hit.append(head);
    if (said) hit.append(make("p", short(said), "said"));
    if (record.note) hit.append(make("p", short(record.note), "quiet"));
    hit.append(make("code", record.address, "quiet"));
    return hit;
  };

  const show = (text, most) => {
    const hits = window.RANK.search(records, index, text);
    list.replaceChildren(...hits.slice(0, most).map(({ record }) => item(record)));
    const left = hits.length - most;
    status.textContent = hits.length
      ? `${hits.length} ${hits.length === 1 ? "place" : "places"}${left > 0 ? `, the best ${most} of them; another word makes them fewer` : ""}`
      : "Nothing found. Try a number as it is printed, a place such as Eq. (6), or one word less.";
  };

  const text = new URLSearchParams(location.search).get("q") || "";
  input.value = text;
  if (text.trim()) show(text, MOST);
  else input.focus();
})();
