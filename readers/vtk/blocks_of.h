// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;

namespace pellucid::readers {

/// A NamedBlock is a data set within others: its name and those around it, "boundary/inlet".
struct NamedBlock {
  std::string name;
  vtkSmartPointer<vtkDataSet> data;
};

/// Returns the data sets that hold points, in their order; of one data set itself, without a name.
/// What has no name is numbered among its neighbours.
std::vector<NamedBlock> blocks_within(vtkDataObject* data);

/// Says whether each of the names in `wanted` means one of the blocks, as chosen_blocks() has it.
bool has_blocks(const std::vector<NamedBlock>& blocks, const std::string& wanted);

/// Returns the blocks that `wanted` names, "inlet,outlet": by their whole name, its first or its
/// last part. All when it is empty. Throws InputError after `file` that lists the names.
std::vector<NamedBlock> chosen_blocks(std::vector<NamedBlock> blocks, const std::string& wanted,
                                      const std::string& file);

/// Returns the blocks in one data set: a single one as it is, of several an unstructured grid,
/// which keeps the arrays that all of them have.
vtkSmartPointer<vtkDataSet> merged(const std::vector<NamedBlock>& blocks);

}  // namespace pellucid::readers
