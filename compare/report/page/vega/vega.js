// SPDX-License-Identifier: GPL-3.0-or-later
// What Vega's own index does, for the packages that the plots need.
const vega = (() => {
  const { transforms } = require("vega-dataflow");
  for (const name of ["vega-transforms", "vega-view-transforms", "vega-encode", "vega-label"])
    Object.assign(transforms, require(name));
  return { View: require("vega-view").View, parse: require("vega-parser").parse };
})();
