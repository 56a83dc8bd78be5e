// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "compare/methods/methods.h"
#include "compare/results/columns.h"
#include "compare/results/measure_columns.h"
#include "compare/run/run_study.h"
#include "compare/study/study.h"
#include "core/error.h"
#include "module/module.h"
#include "module/values.h"
#include "module/work.h"

namespace pellucid::python {
namespace {

/// Results are what is known of a study after a run.
struct Results {
  std::vector<compare::ResultRow> rows;
  std::string folder;
};

py::object value_of(const std::optional<double>& value) {
  if (!value) return py::none();
  return py::float_(*value);
}

/// The columns of results.csv: numbers that a row lacks are None.
py::dict row_dict(const compare::ResultRow& row, std::span<const scene::Measure> measures) {
  py::dict dict;
  dict["scene"] = row.scene;
  dict["method"] = row.method;
  dict["parameters"] = row.parameters;
  const bool done = row.error.empty();
  for (const compare::Column& column : compare::columns())
    dict[py::str(column.name)] = value_of(done ? column.value(row) : std::nullopt);
  for (const scene::Measure& measure : measures)
    dict[py::str(measure.name)] = value_of(compare::measure_of(row, measure.name));
  dict["error"] = row.error;
  return dict;
}

py::list rows_of(const Results& results) {
  const auto measures = compare::measure_columns(results.rows);
  py::list rows;
  for (const compare::ResultRow& row : results.rows) rows.append(row_dict(row, measures));
  return rows;
}

Results run_study(const py::object& study, const py::object& out, bool resume,
                  const py::object& only, const py::object& gl) {
  const std::string name = path_of(study, "run_study: study");
  compare::StudyOptions options;
  options.folder = path_of(out, "run_study: out");
  options.resume = resume;
  options.only = texts_of(only, "run_study: only");
  std::erase(options.only, "");
  options.context.gl = text_of(gl, "run_study: gl");
  return result_unlocked([&](const Progress& progress) {
    options.progress = progress;
    const compare::Study loaded =
        compare::load_study(compare::find_study(name), compare::callable_methods());
    return Results{compare::run_study(loaded, options).rows, options.folder.string()};
  });
}

constexpr const char* study_doc =
    R"(Runs a study file, or a study by its name (`pellucid list studies`).

out: the folder that gets results.csv, results.json, pictures and report.html. resume: keep finished
cells. only: run the cells whose SCENE, METHOD or SCENE/METHOD:PARAMETERS fits this pattern, or one of several.
A cell that fails is a row with its error. Raises InputError.)";

}  // namespace

void define_study(py::module_& module) {
  py::class_<Results>(module, "Results", "What is known of a study after a run.")
      .def_property_readonly("rows", rows_of,
                             "A dict for each cell, by the columns of results.csv (`pellucid list "
                             "columns`); numbers that a cell lacks are None.")
      .def_property_readonly(
          "folder", [](const Results& r) { return r.folder; }, "Where the results are.")
      .def(
          "to_pandas",
          [](const Results& r) {
            return py::module_::import("pandas").attr("DataFrame")(rows_of(r));
          },
          "Returns the rows as a pandas.DataFrame.")
      .def("__repr__", [](const Results& r) {
        return fmt::format("<pellucid.Results: {} rows in {}>", r.rows.size(), r.folder);
      });
  module.def("run_study", run_study, py::arg("study"), py::arg("out"), py::kw_only(),
             py::arg("resume") = false, py::arg("only") = "", py::arg("gl") = "osmesa", study_doc);
}

}  // namespace pellucid::python
