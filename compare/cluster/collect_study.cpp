// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cluster/collect_study.h"

#include <fmt/format.h>

#include "compare/cells/known_cell.h"
#include "compare/report/results_folder.h"
#include "compare/run/study_jobs.h"
#include "core/error.h"

namespace pellucid::compare {
namespace {

/// Takes the jobs of one scene after another, of each the reference first.
class Collector {
 public:
  void take(const Job& job) {
    KnownCell known = known_cell(job.files, job.fingerprint, hashes_);
    if (known.row)
      take_row(job, std::move(*known.row));
    else if (!job.cell.reference && reference_failed_)
      collection_.rows.push_back(failed_row(job, reference_failed));
    else
      take_missing(job, std::move(known.fault));
  }
  Collection collection() { return std::move(collection_); }

 private:
  void take_row(const Job& job, ResultRow row) {
    if (job.cell.reference) reference_failed_ = !row.error.empty();
    collection_.rows.push_back(std::move(row));
  }
  void take_missing(const Job& job, std::string fault) {
    if (job.cell.reference) reference_failed_ = false;
    collection_.missing.push_back({job.cell.name(), std::move(fault)});
  }

  Collection collection_;
  ContentHashes hashes_;
  bool reference_failed_ = false;  // of the scene at hand
};

}  // namespace

std::string MissingCell::text() const {
  return fault.empty() ? cell : fmt::format("{} (there, but {})", cell, fault);
}

Collection collect_study(const Study& study, const StudyOptions& options) {
  Collector collector;
  for (const Job& job : make_jobs(study, options)) collector.take(job);
  Collection collection = collector.collection();
  if (collection.rows.empty())
    throw WorkError(fmt::format("{}: none of the {} cells of {} is there; --plan names them",
                                options.folder.string(), collection.missing.size(),
                                study.file.string()));
  write_results(options.folder, study, collection.rows, options.report);
  return collection;
}

}  // namespace pellucid::compare
