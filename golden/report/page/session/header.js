// The head of the session page: what the logs are, and what is missing from them or from the page.
import { element } from "../theme.js";

const chip = (words, kind = "") => element("span", { className: `chip ${kind}`, textContent: words });

function facts_of(session) {
  const { head, bodies, rows } = session;
  const steps = head.last - head.first;
  const chips = [chip(head.engine ?? `method ${head.method}`), chip(`${steps} step${steps === 1 ? "" : "s"}`),
    chip(`${Number(session.time_of(head.last).toPrecision(4))} s`), chip(`${bodies.count} bod${bodies.count === 1 ? "y" : "ies"}`)];
  if (!head.finished) chips.push(chip(session.thin ? "not finished: shown to its last chunk" : "not finished: followed to its last chunk", "warn"));
  else if (!head.sound || session.gaps().length > 0) chips.push(chip("damaged", "fail"));
  if (head.cut_short) chips.push(chip("cut short", "warn"));
  if (rows.lost.some((count) => count > 0)) chips.push(chip("bodies lost", "fail"));
  return chips;
}

function notices_of(page) {
  const notices = [];
  const two = page.sessions.length === 2;
  page.sessions.forEach((session, i) => {
    const who = two ? `${"AB"[i]}: ` : "";
    const { head, thin } = session;
    if (!head.sound && head.finished) notices.push(["fail", `${who}${head.summary}`]);
    if (head.cut_short) notices.push(["warn", `${who}The session may have gone on: ${head.cut_short}`]);
    for (const [first, last, why] of session.gaps()) notices.push(["fail", `${who}steps ${first} to ${last}: ${why}`]);
    if (session.note) notices.push(["fail", `${who}${session.note}`]);
    if (session.unread && session.unread !== session.note) notices.push(["fail", `${who}The timeline was not read: ${session.unread}`]);
    if (head.axes) notices.push(["", `${who}the engine has other axes (${head.axes}); this page shows places in m, z up${two ? ", and names the first difference by the engine's axes" : ""}`]);
    if (!thin) return;
    const every = thin.every > 1;
    const kept = every ? `is thinned: it has ${thin.steps.length} of ${head.last - head.first + 1} states${thin.every < head.last - head.first ? ` (one in ${thin.every}, and those of inputs)` : ""}`
      : session.gaps().length > 0 ? "has every state that could be read" : "has every state";
    const contacts = session.rows.without_contacts() ? "" : `, with the contacts of ${thin.contact_steps} state${thin.contact_steps === 1 ? "" : "s"}`;
    const rows = thin.rows_run > 1 ? `; its timeline has the largest values of ${thin.rows_run} steps each` : "";
    notices.push([every ? "warn" : "", `${who}This page ${kept}, rounded to 0.1 mm${contacts}${rows}. Served by tumble view it has every bit.`]);
  });
  const why = page.sessions[0].rows.begun_why_not;
  if (why) notices.push(["", `Contacts begun are counted no further: ${why}`]);
  return notices;
}

export function make_header(page) {
  const title = element("h1");
  const facts = element("div", { className: "facts" });
  const notices = element("div", { className: "notices" });
  const trouble = element("p", { className: "trouble", hidden: true });
  trouble.setAttribute("role", "status");
  const file_name = (path) => path.slice(path.lastIndexOf("/") + 1);
  const show = () => {
    const { sessions } = page;
    title.replaceChildren(...sessions.flatMap(({ head }, i) => {
      const name = element("span", { textContent: file_name(head.path), title: head.path });
      return sessions.length === 1 ? [name] : [element("span", { className: `side side-${"ab"[i]}`, textContent: "AB"[i] }), name, " "];
    }));
    facts.replaceChildren(...sessions.flatMap((session, i) => [
      ...(i > 0 ? [element("span", { className: "side side-b", textContent: "B" })] : []),
      ...(session.head.title && i === 0 ? [element("span", { className: "soft scene", textContent: session.head.title })] : []),
      ...facts_of(session)]));
    notices.replaceChildren(...notices_of(page).map(([kind, words]) => element("p", { className: kind, textContent: words })));
  };
  show();
  return {
    place: element("header", {}, title, facts, notices, trouble),
    show,
    trouble(error) {
      trouble.hidden = error === null;
      trouble.textContent = error === null ? "" : `The server does not answer as it should (${error.message}). ` +
        "If tumble view was ended, start it again.";
    },
  };
}
