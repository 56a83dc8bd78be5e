// SPDX-License-Identifier: GPL-3.0-or-later
// A minimal CommonJS: define(name, body) keeps a module, require(name) runs it once.
const modules = {}, loaded = {};
function define(name, body) { modules[name] = body; }
function require(name) {
  if (!(name in loaded)) {
    const module = { exports: (loaded[name] = {}) };
    modules[name](module.exports, module, require);
    loaded[name] = module.exports;
  }
  return loaded[name];
}
