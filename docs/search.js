// How the site's search reads a query, and which pages it shows first.

const FIRST = /^notebooks\//, THEN = /^(exercises\/|docs\/glossary)/;
const LAST = new RegExp("^(CHANGELOG|benchmarks|tests|solutions"
  + "|docs/(contributing|function_names|grading|licences|own_code|package|rubrics|variants"
  + "|where_it_runs))");

// A* is `astar` in code, and RRT* is `rrt_star`. A single letter, as the C of C-space, is in every
// name; a Greek one is not.
var splitQuery = (query) => query
  .replace(/(?<![\p{Letter}\p{Number}_])a\*/giu, "astar")
  .replace(/(?<=[\p{Letter}\p{Number}])\*/gu, "_star")
  .split(/[^\p{Letter}\p{Number}_]+/u)
  .filter((term) => term && !/^[a-z]$/i.test(term));

// Pages for students come before pages for teachers and contributors. The numbers are Sphinx's.
var Scorer = {
  score: ([page, , , , score]) => score
    + (FIRST.test(page) ? 4 : THEN.test(page) ? 2 : LAST.test(page) ? -12 : 0),
  objNameMatch: 11,
  objPartialMatch: 6,
  objPrio: { 0: 15, 1: 5, 2: -5 },
  objPrioDefault: 0,
  title: 15,
  partialTitle: 7,
  term: 5,
  partialTerm: 2,
};
