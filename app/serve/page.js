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

const svgNode = (name, attributes, text) => {
  const node = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  if (text !== undefined) node.textContent = text;
  return node;
};

/** A drawing of lines, each a list of points; of axes of one scale where `square`. */
function drawing(lines, caption, square, corner) {
  const points = lines.flatMap((line) => line.points).filter(([x, y]) => Number.isFinite(x) && Number.isFinite(y));
  if (points.length === 0) return null;
  const [wide, high, edge] = [360, 240, 24];
  const ends = (of) => [Math.min(...points.map(of)), Math.max(...points.map(of))];
  const [[left, right], [low, top]] = [ends((p) => p[0]), ends((p) => p[1])];
  let [sx, sy] = [(wide - 2 * edge) / (right - left || 1), (high - 2 * edge) / (top - low || 1)];
  if (square) sx = sy = Math.min(sx, sy);
  const at = ([x, y]) => `${(edge + (x - left) * sx).toFixed(1)},${(high - edge - (y - low) * sy).toFixed(1)}`;
  const svg = svgNode("svg", { viewBox: `0 0 ${wide} ${high}`, role: "img", "aria-label": caption });
  for (const line of lines)
    svg.append(svgNode("polyline", { class: line.name, points: line.points.filter((p) => p.every(Number.isFinite)).map(at).join(" ") }));
  const words = (x, y, text, anchor) => svg.append(svgNode("text", { x, y, "text-anchor": anchor }, text));
  words(edge, 15, `${top.toPrecision(3)} ${corner[1]}`, "start");
  words(edge, high - 6, `${left.toPrecision(3)}`, "start");
  words(wide - edge, high - 6, `${right.toPrecision(3)} ${corner[0]}`, "end");
  words(edge, high - edge - 4, low.toPrecision(3), "start");
  const figure = document.createElement("figure"), below = document.createElement("figcaption");
  below.textContent = caption;
  figure.append(svg, below);
  return figure;
}

function restShape(lengths, rest) {
  let [x, y, turned] = [0, 0, 0];
  return [[0, 0], ...lengths.map((length, j) => {
    turned += rest[j];
    return [x += length * Math.cos(turned), y += length * Math.sin(turned)];
  })];
}

function plotsOf(found) {
  return found.runs.slice(0, 6).flatMap((run) => [
    drawing([{ name: "rest", points: restShape(found.link_length, run.rest) },
             { name: "measured", points: run.x.map((x, i) => [x, run.y[i]]) }],
            `${run.id}: ${run.count} readings, the end point's way (blue) and the unloaded chain (orange)`, true, ["m", "m"]),
    drawing([{ name: "measured", points: run.Fx.map((f, i) => [i, f]) }, { name: "second", points: run.Fy.map((f, i) => [i, f]) }],
            `${run.id}: forces Fx (whole line) and Fy (dashed), reading by reading`, false, ["", "N"]),
  ]).filter((one) => one !== null);
}

function show(found) {
  part("read").hidden = false;
  part("work").hidden = true;
  part("question").textContent = found.question;
  part("settings").value = found.settings;
  part("plots").replaceChildren(...plotsOf(found));
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
  part("settings-box").open = found.question !== "";
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

does("take", async () => {
  const form = new FormData();
  for (const file of chosen) form.append(isModel(file.name) ? "model" : "table", file, file.name);
  for (const joint of part("joints").value.split(",").map((one) => one.trim()).filter(Boolean)) form.append("joint", joint);
  form.append("columns", part("columns").value);
  say("Reading …");
  show(await ask("take", form));
  part("read-title").focus();
});
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
