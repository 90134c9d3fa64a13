// The answer of a job, as tabs below the editors.
"use strict";

const tabsOf = [
  ["refused", "Errors"], ["verdict", "Exercise"], ["output", "Output"], ["explanation", "Explanation"], ["listing", "Listing"],
  ["report", "Report"], ["page", "The run's page"], ["warnings", "Warnings"],
];

function panelFor(kind, content, title) {
  if (kind !== "page") {
    const text = document.createElement("pre");
    text.textContent = content;
    text.tabIndex = 0;
    return text;
  }
  // The page of a run is a separate document, which has no access to this page.
  const frame = document.createElement("iframe");
  frame.title = title;
  frame.setAttribute("sandbox", "allow-scripts");
  frame.srcdoc = content;
  return frame;
}

/** Shows one tab. The page of a run is loaded only when its tab is shown, since a hidden page has no size. */
function choose(tab, answer) {
  for (const each of byId("tabs").children) {
    const chosen = each === tab;
    each.setAttribute("aria-selected", chosen);
    each.tabIndex = chosen ? 0 : -1;
    byId(each.getAttribute("aria-controls")).hidden = !chosen;
  }
  const panel = byId(tab.getAttribute("aria-controls"));
  if (!panel.hasChildNodes())
    panel.append(panelFor(tab.dataset.kind, answer[tab.dataset.kind], tab.textContent));
}

function moveTab(event) {
  const all = [...byId("tabs").children], here = all.indexOf(event.target);
  const to = { ArrowLeft: here - 1, ArrowRight: here + 1, Home: 0, End: all.length - 1 }[event.key];
  if (to === undefined)
    return;
  event.preventDefault();
  const tab = all[(to + all.length) % all.length];
  tab.focus();
  tab.click();
}

byId("tabs").addEventListener("keydown", moveTab);

function tabFor(kind, title, answer) {
  const tab = document.createElement("button"), panel = document.createElement("div");
  Object.assign(tab, { id: `tab-${kind}`, textContent: title });
  Object.assign(panel, { id: `panel-${kind}`, hidden: true });
  tab.dataset.kind = kind;
  tab.setAttribute("role", "tab");
  tab.setAttribute("aria-controls", panel.id);
  panel.setAttribute("role", "tabpanel");
  panel.setAttribute("aria-labelledby", tab.id);
  tab.addEventListener("click", () => choose(tab, answer));
  byId("panels").append(panel);
  return tab;
}

/** Shows an answer. The first tab has the requested result, or the error. */
function showAnswer(answer, asked) {
  byId("panels").replaceChildren();
  const shown = tabsOf.filter(([kind]) => answer[kind]);
  byId("tabs").replaceChildren(...shown.map(([kind, title]) => tabFor(kind, title, answer)));
  byId("results").hidden = shown.length === 0;
  const first = answer.refused ? "refused" : asked in answer && answer[asked] ? asked : answer.output ? "output" : "report";
  const tab = byId(`tab-${first}`) ?? byId("tabs").firstElementChild;
  if (tab)
    choose(tab, answer);
  if (answer.faults)
    showFaults(answer.faults);
}

const endings = {
  completed: "The run has completed.", solved: "Solved.", "not solved": "Not solved.", refused: "The program has errors.",
  interrupted: "The run was interrupted: it took too long, or printed too much.", killed: "The run was stopped because it exceeded a limit.",
  failed: "The run has failed.",
};

function sentenceOn(answer) {
  const ended = endings[answer.ended] ?? `The run has ended: ${answer.ended}.`;
  return answer.page_missing ? `${ended} ${answer.page_missing}.` : ended;
}
