// SPDX-License-Identifier: GPL-3.0-or-later
// The controls beside the picture: methods, objects, camera.

const group = (title, ...children) => make("fieldset", {}, make("legend", {}, title), children);

/** One of the two methods with its parameters; `none`: there may be no method. */
function methodGroup(title, method, none, act) {
  const parameters = make("div");
  const fill = () => {
    const row = data.methods.find(({ name }) => name === method.name);
    parameters.replaceChildren(...(row ? row.parameters.map((parameter) => controlOf(parameter, method.values, row.name, act)) : []));
  };
  const options = data.methods.map(({ name, title: what }) => make("option", { value: name, title: what, selected: name === method.name && "" }, name));
  const select = make("select", { "aria-label": title }, none && make("option", { value: "" }, "none"), options);
  select.onchange = () => {
    Object.assign(method, { name: select.value, values: {} });
    fill();
    act();
  };
  fill();
  return group(title, make("label", { class: "control" }, make("span", {}, "method"), select), parameters);
}

const objectGroup = (object, values, act) =>
  group(object.name, object.controls.map((row) => controlOf(row, values, object.name, act)));

/** Cameras: from a side, the file's, saved, printed. `on` has an act for each. */
function cameraGroup(on) {
  const button = (text, act, extra) => make("button", { type: "button", onclick: act, ...extra }, text);
  const side = make("select", { "aria-label": "See all, from a side" }, make("option", { value: "" }, "see all …"),
    data.views.map(({ name, title }) => make("option", { value: name }, `${name}, ${title}`)));
  side.onchange = () => {
    if (side.value) on.fit(side.value);
    side.value = "";
  };
  const said = make("p", { class: "said", role: "status" });
  const say = (act) => async () => { said.textContent = await act(); };
  const saving = data.may_save ? {} : { disabled: "", title: "only a scene that was named on the command line is written" };
  return group("camera", side, make("div", { class: "buttons" }, button("file's camera", on.reset), button("save camera", say(on.save), saving),
    button("print camera", say(on.print)), data.study && button("add to study", say(on.add), { title: data.study })), said);
}

/** The size of the pictures: as large as the window allows, or as the scene file says. */
function sizeGroup(settings, act) {
  const choices = { window: "as the window", scene: `${data.size[0]} × ${data.size[1]}, the scene's` };
  const select = make("select", { "aria-label": "Size of the pictures" }, Object.entries(choices).map(([value, text]) => make("option", { value }, text)));
  select.onchange = () => {
    settings.size = select.value;
    act();
  };
  return make("label", { class: "control" }, make("span", {}, "size"), select);
}
