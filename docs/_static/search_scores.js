// What a search shows first: pages that say in an index entry what they are about, concepts, then how-tos and tutorials, then names, and records of measurements last.
const FOLDERS = { concepts: 4, tutorials: 4, howto: 3, start: 3, measured: -10, benchmarks: -10, studies: -10, changelog: -15 };

var Scorer = {
  // The whole name of what a script calls is what was looked for; a method or a closed form of the same name seldom is.
  score: ([page, title, anchor, description, score, file, kind]) => {
    if (kind === "object") return score + (title.split(".").length === 2 && score >= Scorer.objNameMatch ? 100 : 0);
    return score + (FOLDERS[page.split(/[/-]/)[0]] ?? 0);
  },
  objNameMatch: 20,
  objPartialMatch: 6,
  objPrio: { 0: 0, 1: 0, 2: -5 },
  objPrioDefault: 0,
  title: 15,
  partialTitle: 7,
  term: 5,
  partialTerm: 2,
};
