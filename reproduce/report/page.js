"use strict";
// Sorts a table by a click on a column's head, filters it by text, and lets a count of the verdict show its rows.
// The page can be read without it.
for (const box of document.querySelectorAll("details.table")) {
  const body = box.querySelector("tbody");
  const heads = [...box.querySelectorAll("th")];
  const key = (row, j) => {
    const cell = row.cells[j];
    return cell.dataset.n === undefined ? cell.textContent : Number(cell.dataset.n.replace("inf", "Infinity"));
  };
  const compare = (a, b) =>
    typeof a === "number" && typeof b === "number" ? a - b
      : typeof a === typeof b ? a.localeCompare(b, "en", { numeric: true })
      : typeof a === "number" ? -1 : 1;
  heads.forEach((head, j) => {
    head.addEventListener("click", () => {
      const sign = head.getAttribute("aria-sort") === "ascending" ? -1 : 1;
      heads.forEach((other) => other.removeAttribute("aria-sort"));
      head.setAttribute("aria-sort", sign > 0 ? "ascending" : "descending");
      body.append(...[...body.rows].sort((a, b) => sign * compare(key(a, j), key(b, j))));
    });
  });
  const search = box.querySelector("input");
  if (!search) continue;
  // "verdict: X" is the whole cell, anything else a part of the row's text.
  const show = () => {
    const [, verdict] = search.value.match(/^verdict: (.*)$/) || [];
    const text = search.value.toLowerCase();
    for (const row of body.rows) {
      const chip = row.querySelector(".chip");
      row.hidden = verdict !== undefined
        ? !chip || chip.textContent !== verdict
        : !row.textContent.toLowerCase().includes(text);
    }
  };
  search.addEventListener("input", show);
  box.showVerdict = (verdict) => { box.open = true; search.value = "verdict: " + verdict; show(); };
}
for (const tile of document.querySelectorAll("a[data-filter]")) {
  tile.addEventListener("click", () => {
    const box = document.querySelector(tile.getAttribute("href"));
    if (box && box.showVerdict) box.showVerdict(tile.dataset.filter);
  });
}
// A link to a row opens the table around it.
const openTarget = () => {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  const box = target && target.closest("details");
  if (box && !box.open) { box.open = true; target.scrollIntoView(); }
};
addEventListener("hashchange", openTarget);
openTarget();
