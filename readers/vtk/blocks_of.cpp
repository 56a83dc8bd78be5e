// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtk/blocks_of.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vtkAppendFilter.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataSet.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <iterator>

#include "core/error.h"
#include "core/options/split.h"

namespace pellucid::readers {
namespace {

std::string name_of(vtkInformation* about, unsigned number) {
  const char* name = about ? about->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name && *name ? name : fmt::format("{}", number);
}

void collect(vtkDataObject* data, const std::string& name, std::vector<NamedBlock>& blocks);

template <class Composite, class At, class About>
void collect_all(Composite& composite, unsigned count, const std::string& name, const At& at,
                 const About& about, std::vector<NamedBlock>& blocks) {
  for (unsigned i = 0; i < count; ++i) {
    const std::string own = name_of(composite.HasMetaData(i) ? about(i) : nullptr, i);
    collect(at(i), name.empty() ? own : name + '/' + own, blocks);
  }
}

void collect(vtkDataObject* data, const std::string& name, std::vector<NamedBlock>& blocks) {
  if (auto* set = vtkDataSet::SafeDownCast(data)) {
    if (set->GetNumberOfPoints() > 0) blocks.push_back({name, set});
  } else if (auto* multi = vtkMultiBlockDataSet::SafeDownCast(data)) {
    collect_all(
        *multi, multi->GetNumberOfBlocks(), name, [&](unsigned i) { return multi->GetBlock(i); },
        [&](unsigned i) { return multi->GetMetaData(i); }, blocks);
  } else if (auto* parts = vtkPartitionedDataSet::SafeDownCast(data)) {
    collect_all(
        *parts, parts->GetNumberOfPartitions(), name,
        [&](unsigned i) { return parts->GetPartitionAsDataObject(i); },
        [&](unsigned i) { return parts->GetMetaData(i); }, blocks);
  } else if (auto* all = vtkPartitionedDataSetCollection::SafeDownCast(data)) {
    collect_all(
        *all, all->GetNumberOfPartitionedDataSets(), name,
        [&](unsigned i) { return all->GetPartitionedDataSet(i); },
        [&](unsigned i) { return all->GetMetaData(i); }, blocks);
  }
}

/// Says whether a name is the block's, or the first or the last part of it.
bool is_meant(const NamedBlock& block, std::string_view name) {
  return block.name == name || block.name.starts_with(fmt::format("{}/", name)) ||
         block.name.ends_with(fmt::format("/{}", name));
}

std::vector<NamedBlock> matching(const std::vector<NamedBlock>& blocks, std::string_view name) {
  std::vector<NamedBlock> chosen;
  std::ranges::copy_if(blocks, std::back_inserter(chosen),
                       [&](const NamedBlock& block) { return is_meant(block, name); });
  return chosen;
}

[[noreturn]] void refuse(std::string_view name, const std::vector<NamedBlock>& blocks,
                         const std::string& file) {
  std::vector<std::string> names;
  for (const NamedBlock& block : blocks)
    if (!block.name.empty()) names.push_back(block.name);
  throw InputError(fmt::format(
      "{}: block={}: no such block; accepted: {}", file, name,
      names.empty() ? "none, it holds one data set" : fmt::format("{}", fmt::join(names, ", "))));
}

}  // namespace

std::vector<NamedBlock> blocks_within(vtkDataObject* data) {
  std::vector<NamedBlock> blocks;
  collect(data, "", blocks);
  return blocks;
}

bool has_blocks(const std::vector<NamedBlock>& blocks, const std::string& wanted) {
  return !matching(blocks, wanted).empty() ||
         std::ranges::all_of(split(wanted, ','), [&](std::string_view name) {
           return !matching(blocks, name).empty();
         });
}

std::vector<NamedBlock> chosen_blocks(std::vector<NamedBlock> blocks, const std::string& wanted,
                                      const std::string& file) {
  if (wanted.empty()) return blocks;
  std::vector<NamedBlock> chosen = matching(blocks, wanted);  // a name may have commas
  if (!chosen.empty()) return chosen;
  for (const std::string_view name : split(wanted, ',')) {
    const std::vector<NamedBlock> some = matching(blocks, name);
    if (some.empty()) refuse(name, blocks, file);
    chosen.insert(chosen.end(), some.begin(), some.end());
  }
  return chosen;
}

vtkSmartPointer<vtkDataSet> merged(const std::vector<NamedBlock>& blocks) {
  if (blocks.size() == 1) return blocks.front().data;
  vtkNew<vtkAppendFilter> append;
  for (const NamedBlock& block : blocks) append->AddInputData(block.data);
  append->Update();
  return append->GetOutput();
}

}  // namespace pellucid::readers
