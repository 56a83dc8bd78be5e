// SPDX-License-Identifier: GPL-3.0-or-later
// Controls made of the program's tables: a row has name, kind, default, bounds, unit and help.

/** Bounds within which a slider is finer than a field of digits. */
const fitsSlider = ({ kind, min, max }) => min != null && max != null && (kind === "real" ? max - min < 1e4 : max - min <= 64);

const sliderStops = 200;
/** From this ratio of its ends on a slider's stops are equal factors apart, not equal steps. */
const decadesFrom = 1000;

/** Where stops that are equal factors apart begin; null for equal steps. Of bounds that begin with 0 a default near it says how small a number may count. */
function leastFactor({ min, max, default: usual }) {
  if (min > 0) return max / min >= decadesFrom ? min : null;
  const small = Number(usual) / 100;
  return min === 0 && small > 0 && max / small >= decadesFrom * 10 ? small : null;
}

/** The texts of all values that a slider takes, its bounds, default and present value among them to their last digit; a default that is no
    number, "", comes first. */
function stopsOf(row, value) {
  const between = (i) => {
    const share = i / sliderStops, least = leastFactor(row);
    return least == null ? row.min + share * (row.max - row.min) : least * (row.max / least) ** share;
  };
  const whole = row.kind === "integer";
  const inner = whole ? Array.from({ length: row.max - row.min + 1 }, (_, i) => row.min + i)
                      : Array.from({ length: sliderStops - 1 }, (_, i) => Number(between(i + 1).toPrecision(3)));
  const exact = [String(row.min), String(row.max), row.default, value].filter((text) => text !== "");
  const byNumber = new Map([...inner.map(String), ...exact].map((text) => [Number(text), text]));
  const stops = [...byNumber].filter(([number]) => number >= row.min && number <= row.max).sort((a, b) => a[0] - b[0]).map(([, text]) => text);
  return row.default === "" ? ["", ...stops] : stops;
}

/** A slider's own numbers are the places of its stops. */
function sliderOf(row, value, act) {
  const stops = stopsOf(row, value);
  const input = make("input", { type: "range", min: 0, max: stops.length - 1, step: 1 });
  const output = make("output");
  const say = (text) => {
    output.textContent = text || "default";
    input.setAttribute("aria-valuetext", output.textContent);
  };
  const set = (text) => {
    input.value = stops.findIndex((stop) => stop === text || (stop !== "" && Number(stop) === Number(text)));
    say(text);
  };
  input.oninput = () => {
    say(stops[input.value]);
    act(stops[input.value]);
  };
  set(value);
  return { elements: [input, output], set };
}

function fieldOf(row, value, act) {
  const number = row.kind === "real" || row.kind === "integer";
  const input = make("input", { type: number ? "number" : "text", value, min: row.min, max: row.max, step: row.kind === "integer" ? 1 : "any" });
  input.onchange = () => act(input.value);
  return { elements: [input], set: (text) => { input.value = text; } };
}

function selectOf(choices, value, act) {
  const select = make("select", {}, choices.map((choice) => make("option", { value: choice, selected: choice === value && "" }, choice)));
  select.onchange = () => act(select.value);
  return { elements: [select], set: (text) => { select.value = text; } };
}

function inputsOf(row, value, act) {
  if (row.kind === "choice") return selectOf(row.choices, value, act);
  if (row.kind === "flag") return selectOf(["on", "off"], value, act);
  return (row.kind === "real" || row.kind === "integer") && fitsSlider(row) ? sliderOf(row, value, act) : fieldOf(row, value, act);
}

/** The control of a row; `values` holds the texts that differ from the defaults. `of` says whose it is. What differs has a button that takes it back. */
function controlOf(row, values, of, act) {
  const reset = make("button", { type: "button", class: "reset", "aria-label": `Reset ${row.name} of ${of}`, title: `back to ${row.default || "the default"}` }, "↺");
  const keep = (text) => {
    if (text === row.default || text === "") delete values[row.name];
    else values[row.name] = text;
    reset.classList.toggle("idle", !(row.name in values));
    act();
  };
  const { elements, set } = inputsOf(row, values[row.name] ?? row.default, keep);
  reset.onclick = () => {
    set(row.default);
    elements[0].focus();
    keep(row.default);
  };
  reset.classList.toggle("idle", !(row.name in values));
  const unit = row.unit && row.unit !== "1" ? ` [${row.unit}]` : "";
  elements[0].setAttribute("aria-label", `${row.name}${unit} of ${of}`);
  return make("div", { class: "control", title: `${row.help} (accepted: ${row.accepted})` }, make("span", {}, row.name, make("small", {}, unit)), elements, reset);
}

/** As on the command line. */
function callOf({ name, values }) {
  const options = Object.entries(values).map(([key, value]) => `${key}=${value}`);
  return options.length > 0 ? `${name}:${options.join(",")}` : name;
}
