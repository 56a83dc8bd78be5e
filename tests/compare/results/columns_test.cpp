// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/results/columns.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "compare/report/tables.h"
#include "compare/results/best_row.h"
#include "core/options/names.h"

namespace pellucid::compare {
namespace {

using ::testing::StartsWith;

/// A row in which every column has a number, and no two the same.
ResultRow filled_row() {
  ResultRow row;
  row.scene = "one";
  row.method = "fourier";
  row.parameters = "bands=5";
  for (std::size_t i = 0; i < metrics().size(); ++i) {
    row.metrics.linear[i] = 0.1 + double(i) / 128;
    row.metrics.displayed[i] = 0.3 + double(i) / 128;
  }
  row.metrics.linear.covered = 0.9375;
  row.seconds = {0.0625, 0.03125, 0.09375, Interval{0.046875, 0.078125}};
  row.setup_seconds = 0.015625;
  row.first_seconds = 0.171875;
  row.gl_seconds = 0.0546875;
  row.settled = true;
  row.calibrations = {{1000, 0.002}, {1001, 0.003}};
  row.repeats = 3;
  row.bytes = {{"list", 1000}, {"heads", 24}};
  row.fragments = 70;
  row.stored = 50;
  row.dropped = 20;
  row.truncated = 11;
  row.max_layers = 4;
  row.coverage = CoverageCheck{13, 6, 100, 0.046875};
  return row;
}

std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> split;
  std::stringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) split.push_back(field);
  return split;
}

/// The lines of a table of one row: head and numbers.
std::pair<std::vector<std::string>, std::vector<std::string>> csv_lines(const ResultRow& row) {
  std::stringstream csv(csv_table(std::span(&row, 1)));
  std::string head, line;
  std::getline(csv, head);
  std::getline(csv, line);
  return {fields(head), fields(line)};
}

TEST(PropertyColumns, NamesAndTitlesAreUnique) {
  std::set<std::string> names, titles;
  for (const Column& column : columns()) {
    EXPECT_TRUE(names.insert(column.name).second) << column.name;
    EXPECT_TRUE(titles.insert(column.title).second) << column.title;
    EXPECT_FALSE(column.unit.empty()) << column.name;
  }
}

TEST(PropertyColumns, EveryOneReadsItsOwnNumber) {
  const ResultRow row = filled_row();
  std::set<double> values;
  for (const Column& column : columns()) {
    const std::optional<double> value = column.value(row);
    ASSERT_TRUE(value) << column.name;
    EXPECT_TRUE(values.insert(*value).second) << column.name << " has another's number";
  }
}

TEST(PropertyColumns, AreThoseOfTheCsvAfterItsNames) {
  EXPECT_THAT(csv_table({}), StartsWith("scene,method,parameters,rmse,ssim,psnr,seconds,bytes,"
                                        "fragments,max_layers,"));
  std::vector<std::string> expected{"scene", "method", "parameters"};
  for (const Column& column : columns()) expected.push_back(column.name);
  expected.emplace_back("error");
  EXPECT_EQ(csv_lines(filled_row()).first, expected);
}

TEST(PropertyColumns, TheCsvHasEveryDigit) {
  const ResultRow row = filled_row();
  const auto line = csv_lines(row).second;
  ASSERT_EQ(line.size(), columns().size() + 3);
  for (std::size_t i = 0; i < columns().size(); ++i)
    EXPECT_EQ(std::strtod(line[i + 3].c_str(), nullptr), columns()[i].value(row))
        << columns()[i].name;
}

TEST(PropertyColumns, AFailedCellHasNone) {
  ResultRow row = filled_row();
  row.error = "lost";
  const auto line = csv_lines(row).second;
  ASSERT_EQ(line.size(), columns().size() + 4);
  for (std::size_t i = 0; i < columns().size(); ++i) EXPECT_EQ(line[i + 3], "") << i;
  EXPECT_EQ(line.back(), "lost");
}

TEST(PropertyColumns, SurviveJson) {
  const ResultRow row = filled_row(), again = row_from_json(to_json(row));
  for (const Column& column : columns())
    EXPECT_EQ(column.value(again), column.value(row)) << column.name;
}

TEST(UnitColumns, WhatIsSaidOfTimesSurvivesJson) {
  const ResultRow row = filled_row(), again = row_from_json(to_json(row));
  EXPECT_EQ(again.settled, true);
  ASSERT_EQ(again.calibrations.size(), 2u);
  EXPECT_EQ(again.calibrations[1].at, 1001);
  EXPECT_EQ(again.calibrations[1].seconds, 0.003);
  EXPECT_EQ(again.seconds.interval->high, 0.078125);
}

TEST(UnitColumns, MillisecondsAreThoseOfTheSeconds) {
  const ResultRow row = filled_row();
  const auto value = [&](const char* name) {
    return find_row("column", name, columns()).value(row);
  };
  EXPECT_EQ(value("ms"), 62.5);
  EXPECT_EQ(value("ms_low"), 46.875);
  EXPECT_EQ(value("ms_high"), 78.125);
  EXPECT_EQ(value("first_frame_ms"), 1e3 * (0.015625 + 0.171875));
  EXPECT_EQ(value("repeats"), 3);
}

// Three repeats have no interval of 95 %.
TEST(UnitColumns, WhatIsNotKnownIsEmpty) {
  ResultRow row = filled_row();
  row.seconds.interval.reset();
  for (const char* name : {"ms_low", "ms_high"})
    EXPECT_FALSE(find_row("column", name, columns()).value(row)) << name;
}

TEST(UnitColumns, TimesWhoseIntervalsOverlapAreTied) {
  const Column& seconds = find_row("column", "seconds", columns());
  ResultRow a = filled_row(), b = filled_row();
  b.seconds.interval = Interval{0.078125, 0.1};
  EXPECT_TRUE(are_tied(seconds, a, b));
  b.seconds.interval = Interval{0.0782, 0.1};
  EXPECT_FALSE(are_tied(seconds, a, b));
  b.seconds.interval.reset();
  EXPECT_FALSE(are_tied(seconds, a, b));
  EXPECT_FALSE(are_tied(find_row("column", "rmse", columns()), a, a));
  EXPECT_EQ(text_with_interval(seconds, a), "62.5 (46.9–78.1)");
  EXPECT_EQ(text_with_interval(seconds, b), "62.5");
}

TEST(UnitColumns, TimesWithoutAnIntervalDecideNothing) {
  const Column& seconds = find_row("column", "seconds", columns());
  std::vector<ResultRow> rows{filled_row(), filled_row()};
  rows[1].seconds.median *= 2;
  EXPECT_TRUE(is_among_best(seconds, rows[0], rows));
  rows[0].seconds.interval.reset();
  EXPECT_TRUE(is_undecided(seconds, rows));
  EXPECT_FALSE(is_among_best(seconds, rows[0], rows));
  EXPECT_TRUE(is_among_best(seconds, rows[0], {rows.data(), 1}));  // nothing beside it
  EXPECT_TRUE(is_among_best(find_row("column", "bytes", columns()), rows[0], rows));
}

TEST(UnitColumns, OnlyEqualPicturesHaveASimilarityOf1) {
  EXPECT_EQ(number_for_people(NumberStyle::similarity, 1), "1");
  EXPECT_EQ(number_for_people(NumberStyle::similarity, 1 - 1e-9), ">0.9999");
  EXPECT_EQ(number_for_people(NumberStyle::similarity, 0.99994), "0.9999");
  EXPECT_EQ(number_for_people(NumberStyle::similarity, 0.98), "0.9800");
}

TEST(UnitColumns, LatexHasItsOwnSigns) {
  EXPECT_EQ(latex_escaped("a<b>|c"), "a\\textless{}b\\textgreater{}\\textbar{}c");
}

// JSON has no infinity: it is a text, and a number that is not there is null.
TEST(UnitColumns, WhatIsInfiniteOrMissingSurvivesJson) {
  ResultRow row = filled_row();
  row.metrics.linear.of("psnr") = std::numeric_limits<double>::infinity();
  row.metrics.linear.of("ssim") = std::nullopt;
  row.measures = {{"epsilon2_view", "ε²", "", std::numeric_limits<double>::infinity()}};
  nlohmann::json json = nlohmann::json::parse(to_json(row).dump());
  EXPECT_EQ(json.at("metrics").at("psnr"), "inf");
  EXPECT_TRUE(json.at("metrics").at("ssim").is_null());
  const ResultRow again = row_from_json(json);
  EXPECT_EQ(again.metrics.linear.of("psnr"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(again.metrics.linear.of("ssim"), std::nullopt);
  json["metrics"]["psnr"] = nullptr;  // as earlier builds wrote it
  EXPECT_EQ(row_from_json(json).metrics.linear.of("psnr"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(again.measures.at(0).value, std::numeric_limits<double>::infinity());
}

// A study goes on from rows that an earlier build wrote, when there was no such metric.
TEST(PropertyColumns, ARowWithoutAMetricIsReadAllTheSame) {
  for (std::size_t i = 0; i < metrics().size(); ++i) {
    nlohmann::json json = to_json(filled_row());
    json["metrics"].erase(std::string(metrics()[i].name));
    const ResultRow row = row_from_json(json);
    EXPECT_EQ(row.metrics.linear[i], std::nullopt) << metrics()[i].name;
    EXPECT_EQ(row.metrics.displayed[i], filled_row().metrics.displayed[i]) << metrics()[i].name;
  }
}

TEST(UnitColumns, PeopleReadMillisecondsAndMegabytes) {
  EXPECT_EQ(number_for_people(NumberStyle::milliseconds, 0.0125), "12.5");
  EXPECT_EQ(number_for_people(NumberStyle::megabytes, 2.5e6), "2.5");
  EXPECT_EQ(number_for_people(NumberStyle::megabytes, 7200), "0.0072");
  EXPECT_EQ(number_for_people(NumberStyle::megabytes, 0), "0.0");
  EXPECT_EQ(number_for_people(NumberStyle::decibels, std::numeric_limits<double>::infinity()), "∞");
  EXPECT_EQ(heading("Time", NumberStyle::milliseconds), "Time [ms]");
  EXPECT_EQ(heading("RMSE", NumberStyle::scientific), "RMSE");
}

// The page draws one error against each cost, and takes all numbers from its table.
TEST(PropertyColumns, WhatThePageShowsIsInItsTable) {
  int errors = 0, costs = 0;
  for (const Column& column : columns()) {
    const Shown& shown = column.shown;
    errors += shown.role == TradeOff::error;
    costs += shown.role == TradeOff::cost;
    if (shown.card || shown.sweeps || shown.role != TradeOff::none) {
      EXPECT_TRUE(shown.report) << column.name;
    }
    if (shown.role != TradeOff::none) {
      EXPECT_EQ(column.better, Better::lower) << column.name;
    }
  }
  EXPECT_EQ(errors, 1);
  EXPECT_GT(costs, 0);
}

TEST(PropertyColumns, NamesOfDirectionsReadBack) {
  for (const Better better : {Better::lower, Better::higher, Better::neither})
    EXPECT_EQ(better_of_name(name_of(better)), better);
}

}  // namespace
}  // namespace pellucid::compare
