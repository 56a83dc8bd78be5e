// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtk/blocks_of.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vtkAppendFilter.h>
#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPointData.h>
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
    collect(at(i), name.empty() ? own : fmt::format("{}/{}", name, own), blocks);
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

/// What holds the arrays of points, or of cells, of a data set.
using Group = vtkDataSetAttributes* (*)(vtkDataSet& data);

/// Whether all have the array, and not all its numbers as the same type.
bool differs_in_type(const std::vector<vtkSmartPointer<vtkDataSet>>& all, Group group,
                     const char* name) {
  bool differs = false;
  int type = -1;
  for (const auto& data : all) {
    vtkDataArray* const array = group(*data)->GetArray(name);
    if (!array) return false;
    if (type >= 0 && array->GetDataType() != type) differs = true;
    type = array->GetDataType();
  }
  return differs;
}

void make_double(vtkDataSetAttributes& arrays, const char* name) {
  vtkNew<vtkDoubleArray> doubles;
  doubles->DeepCopy(arrays.GetArray(name));
  doubles->SetName(name);
  arrays.AddArray(doubles);  // in the other's place, active as it was
}

/// The data of blocks, whose arrays of one name are of one type: the filter that appends them
/// leaves out in silence what is float in one and double in another.
std::vector<vtkSmartPointer<vtkDataSet>> alike(const std::vector<NamedBlock>& blocks) {
  std::vector<vtkSmartPointer<vtkDataSet>> all;
  for (const NamedBlock& block : blocks) {
    all.push_back(vtk::TakeSmartPointer(block.data->NewInstance()));
    all.back()->ShallowCopy(block.data);
  }
  constexpr Group groups[] = {
      [](vtkDataSet& data) -> vtkDataSetAttributes* { return data.GetPointData(); },
      [](vtkDataSet& data) -> vtkDataSetAttributes* { return data.GetCellData(); }};
  for (const Group group : groups)
    for (int k = 0; k < group(*all.front())->GetNumberOfArrays(); ++k) {
      const char* const name = group(*all.front())->GetArrayName(k);
      if (!name || !differs_in_type(all, group, name)) continue;
      const std::string kept = name;  // beyond the array that has it
      for (const auto& data : all) make_double(*group(*data), kept.c_str());
    }
  return all;
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
  for (const auto& data : alike(blocks)) append->AddInputData(data);
  append->Update();
  return append->GetOutput();
}

}  // namespace pellucid::readers
