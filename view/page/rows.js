// SPDX-License-Identifier: GPL-3.0-or-later
// Controls made of the program's tables: a row has name, kind, default, bounds, unit and help.

/** Bounds within which a slider is finer than a field of digits. */
const fitsSlider = ({ kind, min, max }) => min != null && max != null && (kind === "real" ? max - min < 1e4 : max - min <= 64);

function sliderOf(row, value, act) {
  const step = row.kind === "integer" ? 1 : Number(((row.max - row.min) / 200).toPrecision(1));
  const input = make("input", { type: "range", min: row.min, max: row.max, step, value: value === "" ? row.max : value });
  const output = make("output", {}, value === "" ? "file's" : value);
  input.oninput = () => {
    output.textContent = input.value;
    act(input.value);
  };
  return [input, output];
}

function fieldOf(row, value, act) {
  const number = row.kind === "real" || row.kind === "integer";
  const input = make("input", { type: number ? "number" : "text", value, min: row.min, max: row.max, step: row.kind === "integer" ? 1 : "any" });
  input.onchange = () => act(input.value);
  return [input];
}

function selectOf(choices, value, act) {
  const select = make("select", {}, choices.map((choice) => make("option", { value: choice, selected: choice === value && "" }, choice)));
  select.onchange = () => act(select.value);
  return [select];
}

function inputsOf(row, value, act) {
  if (row.kind === "choice") return selectOf(row.choices, value, act);
  if (row.kind === "flag") return selectOf(["on", "off"], value, act);
  return (row.kind === "real" || row.kind === "integer") && fitsSlider(row) ? sliderOf(row, value, act) : fieldOf(row, value, act);
}

/** The control of a row; `values` holds the texts that differ from the defaults. `of` says whose it is. */
function controlOf(row, values, of, act) {
  const inputs = inputsOf(row, values[row.name] ?? row.default, (text) => {
    if (text === row.default || text === "") delete values[row.name];
    else values[row.name] = text;
    act();
  });
  const unit = row.unit && row.unit !== "1" ? ` [${row.unit}]` : "";
  inputs[0].setAttribute("aria-label", `${row.name}${unit} of ${of}`);
  return make("label", { class: "control", title: `${row.help} (accepted: ${row.accepted})` }, make("span", {}, row.name, make("small", {}, unit)), inputs);
}

/** As on the command line. */
function callOf({ name, values }) {
  const options = Object.entries(values).map(([key, value]) => `${key}=${value}`);
  return options.length > 0 ? `${name}:${options.join(",")}` : name;
}
