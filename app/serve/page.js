"use strict";
// The page of `plumbline serve`: what a person drops goes to the program on this machine, and nowhere else.

const part = (id) => document.getElementById(id);
let chosen = [];

function say(text, wrong = false) {
  part("say").textContent = text;
  part("say").classList.toggle("wrong", wrong);
}

async function ask(what, body) {
  const answer = await fetch(what, { method: "POST", body });
  let found;
  try {
    found = await answer.json();
  } catch {
    throw new Error(answer.status === 413 ? "the files are larger than 32 MB together" : "no answer: does the program still run?");
  }
  if (!answer.ok) throw new Error(found.error);
  return found;
}

/** Does what a button asks; what goes wrong is said. */
function does(id, work) {
  part(id).addEventListener("click", async () => {
    part(id).disabled = true;
    try {
      await work();
    } catch (wrong) {
      say(wrong.message, true);
    }
    part(id).disabled = id === "take" && chosen.length === 0;
  });
}

const isModel = (name) => /\.(xml|urdf|sdf|toml)$/i.test(name);

/** Files add up; one of a name that is there, or another model, takes its place. */
function choose(files) {
  const added = [...files], model = added.some((file) => isModel(file.name));
  chosen = chosen.filter((old) => !added.some((file) => file.name === old.name) && !(model && isModel(old.name))).concat(added);
  part("chosen").replaceChildren(...chosen.map((file) => {
    const line = document.createElement("li");
    line.textContent = `${file.name}: ${isModel(file.name) ? "the model" : "readings"}, ${Math.ceil(file.size / 1024)} kB`;
    return line;
  }));
  part("take").disabled = chosen.length === 0;
  say(chosen.length ? `${chosen.length} files chosen` : "");
}

/** An element with its attributes and what is in it. */
function made(name, attributes, ...within) {
  const node = document.createElement(name);
  Object.assign(node, attributes);
  node.append(...within);
  return node;
}

function figureOf(chart) {
  // Drawn by the program: well-formed, and without a script, which this page would not run.
  const svg = new DOMParser().parseFromString(chart.svg, "text/html").querySelector("svg");
  return made("figure", {}, made("figcaption", { textContent: chart.caption }), svg);
}

// --- the tables, with a meaning above each column

const choice = (value, text, taken) => made("option", { value, textContent: text, selected: value === taken });

/** Meaning, unit and sign of a column; `column` keeps what is chosen. */
function meaningOf(column, found) {
  const label = (what) => `${what} of ${column.title || "column " + column.name}`;
  const words = found.channels.flatMap((one) => !one.numbered ? [[one.word, one.means]]
    : [[one.word, one.means], ...Array.from({ length: found.joints }, (_, j) => [one.word + (j + 1), `${one.means} ${j + 1}`])]);
  const channel = made("select", { ariaLabel: label("Meaning") }, choice("", "not used", column.channel),
                       ...words.map(([word, means]) => choice(word, `${means} (${word})`, column.channel)));
  const unit = made("select", { ariaLabel: label("Unit") }), sign = made("select", { ariaLabel: label("Sign") },
    choice("1", "as read", String(column.sign)), choice("-1", "reversed", String(column.sign)));
  const offerUnits = () => {
    const kind = found.channels.find((one) => one.word === column.channel.replace(/\d+$/, "")), units = new Set(kind?.units ?? []);
    if (column.unit && units.size) units.add(column.unit);
    unit.replaceChildren(choice("", "unit by the program", column.unit), ...[...units].map((one) => choice(one, one, column.unit)));
    unit.hidden = units.size === 0;
    sign.hidden = column.channel === "" || column.channel === "ignore";
  };
  offerUnits();
  const changed = () => {
    Object.assign(column, { channel: channel.value, unit: unit.value, sign: Number(sign.value), told: true });
    offerUnits();
    fillTold(found);
  };
  for (const one of [channel, unit, sign]) one.addEventListener("change", changed);
  return made("th", { scope: "col" }, made("span", { textContent: column.title || "column " + column.name }), channel, unit, sign);
}

/** The field that the program reads, filled with what the person chose. */
function fillTold(found) {
  const told = found.tables.flatMap((table) => table.columns).filter((column) => column.told);
  part("columns").value = told.map(({ channel, name, unit, sign }) =>
    `${channel || "ignore"}=${sign < 0 ? "-" : ""}${name.replace(/[,:]/g, "$&$&")}${unit ? ":" + unit : ""}`).join(",");
  say("Chosen. Read again to take it.");
}

function tableOf(table, found) {
  const rows = table.columns.length ? table.columns[0].first.map((_, i) =>
    made("tr", {}, ...table.columns.map((column) => made("td", { textContent: column.first[i] ?? "" })))) : [];
  return made("div", { className: "scroll", tabIndex: 0, role: "region", ariaLabel: `First lines of ${table.file}` },
    made("table", {}, made("caption", { textContent: `${table.file}: what each column means` }),
         made("thead", {}, made("tr", {}, ...table.columns.map((column) => meaningOf(column, found)))), made("tbody", {}, ...rows)));
}

function show(found) {
  part("read").hidden = false;
  part("work").hidden = true;
  part("question").textContent = found.question;
  part("settings").value = found.settings;
  part("plots").replaceChildren(...found.charts.map(figureOf));
  part("tables").replaceChildren(...found.tables.map((table) => tableOf(table, found)));
  part("retell").hidden = found.tables.length === 0;
  part("begin").disabled = found.settings === "";
  const rows = [...found.notes.map((note) => ["model", note, "what the file has"]),
                ...found.guesses.map((one) => [one.what + (one.doubtful ? " (look at it)" : ""), one.value, one.reason])];
  part("guesses").replaceChildren(...rows.map((cells) => {
    const row = document.createElement("tr");
    row.append(...cells.map((text, i) => {
      const cell = document.createElement(i === 0 ? "th" : "td");
      if (i === 0) cell.scope = "row";
      cell.textContent = text;
      return cell;
    }));
    return row;
  }));
  part("settings-box").open = found.question !== "" && found.settings !== "";
  const doubtful = found.guesses.filter((one) => one.doubtful).length;
  part("guesses-box").open = doubtful > 0;
  say(found.question !== "" ? "Read; something is asked."
      : "Read. Nothing looks like another unit, sign, axis or order." + (doubtful ? ` Look at what was guessed: ${doubtful} in doubt.` : ""));
}

async function watch() {
  for (;;) {
    const answer = await fetch("progress");
    const found = await answer.json();
    part("share").value = found.share;
    if (found.state !== "busy") return found;
    await new Promise((done) => setTimeout(done, 250));
  }
}

function showResult(found) {
  part("busy").hidden = true;
  part("words").textContent = found.words;
  const done = found.state === "done";
  part("report").hidden = part("whole").hidden = !done;
  if (done) part("report").src = "report";
  part("words-box").open = !done;
  part("models").replaceChildren(...found.models.map((name) => {
    const line = document.createElement("li"), link = document.createElement("a");
    link.href = `model/${encodeURIComponent(name)}`;
    link.download = name;
    link.textContent = `Corrected model: ${name}`;
    line.append(link);
    return line;
  }));
  say(done ? "Diagnosed." : found.state === "failed" ? found.words : "Given up.", found.state === "failed");
}

async function take() {
  const form = new FormData();
  for (const file of chosen) form.append(isModel(file.name) ? "model" : "table", file, file.name);
  for (const joint of part("joints").value.split(",").map((one) => one.trim()).filter(Boolean)) form.append("joint", joint);
  form.append("columns", part("columns").value);
  say("Reading …");
  show(await ask("take", form));
  part("read-title").focus();
}

/** The report's frame is as high as the report. */
part("report").addEventListener("load", () => {
  const body = part("report").contentDocument?.body;
  if (!body) return;
  const fit = () => { part("report").style.height = `${body.ownerDocument.documentElement.scrollHeight}px`; };
  new ResizeObserver(fit).observe(body);
  fit();
});

does("take", take);
does("retell", take);
does("example", async () => {
  show(await ask("example", ""));
  part("read-title").focus();
});
does("correct", async () => show(await ask("correct", part("settings").value)));
does("begin", async () => {
  await ask("correct", part("settings").value);
  await ask("begin", part("as-is").checked ? "as it is" : "");
  part("work").hidden = part("busy").hidden = false;
  part("report").hidden = part("whole").hidden = true;
  part("words").textContent = "";
  part("models").replaceChildren();
  say("Diagnosing …");
  part("cancel").focus();
  showResult(await watch());
  part("work-title").focus();
});
does("cancel", () => ask("cancel", ""));
part("files").addEventListener("change", () => choose(part("files").files));
for (const kind of ["dragover", "dragleave", "drop"])
  part("drop").addEventListener(kind, (event) => {
    event.preventDefault();
    part("drop").classList.toggle("over", kind === "dragover");
    if (kind === "drop") choose(event.dataTransfer.files);
  });
