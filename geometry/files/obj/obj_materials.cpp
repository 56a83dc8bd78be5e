// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/files/obj/obj_materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/error.h"
#include "core/files/files_read.h"
#include "core/files/output_file.h"
#include "geometry/files/obj/mtl_file.h"
#include "geometry/files/obj/words.h"

namespace pellucid::geometry {
namespace {

/// One name, which may hold blanks, where there is such a file; else several.
std::vector<std::string> names_of(const ObjDocument::Library& library,
                                  const std::filesystem::path& folder) {
  std::error_code none;
  if (std::filesystem::exists(folder / library.names, none)) return {library.names};
  std::vector<std::string> names;
  Words words(library.names);
  for (std::string_view name = words.next(); !name.empty(); name = words.next())
    names.emplace_back(name);
  return names;
}

/// A file that is missing is said: meshes are often passed on without one.
void read_library(const ObjDocument& document, const ObjDocument::Library& library,
                  const std::string& name, MtlMaterials& materials,
                  std::vector<std::string>& remarks) {
  const std::filesystem::path path = document.path.parent_path() / name;
  try {
    require_file(path);
  } catch (const InputError& error) {
    remarks.push_back(fmt::format("mtllib: {}", error.what()));
    // The colours are others once it is there. What is no file, such as a pipe, has no content.
    std::error_code none;
    if (!std::filesystem::exists(path, none)) note_read(path);
    return;
  }
  try {
    read_mtl(path, materials);
  } catch (const InputError& error) {
    throw InputError(
        fmt::format("{}:{}: mtllib: {}", document.path.string(), library.line, error.what()));
  }
}

MtlMaterials read_libraries(const ObjDocument& document, std::vector<std::string>& remarks) {
  MtlMaterials materials;
  for (const ObjDocument::Library& library : document.libraries)
    for (const std::string& name : names_of(library, document.path.parent_path()))
      read_library(document, library, name, materials, remarks);
  return materials;
}

/// "'a'", or "'a' and 2 more".
std::string some_of(const std::vector<std::string>& names) {
  const std::string more =
      names.size() > 1 ? fmt::format(" and {} more", names.size() - 1) : std::string();
  return fmt::format("'{}'{}", names.front(), more);
}

void remark_materials(const ObjDocument& document, const MtlMaterials& materials,
                      std::vector<std::string>& remarks) {
  std::vector<std::string> unknown, textured;
  for (const std::string& name : document.materials)
    if (const auto found = materials.find(name); found == materials.end())
      unknown.push_back(name);
    else if (!found->second.passed_over.empty())
      textured.push_back(name);
  if (!unknown.empty())
    remarks.push_back(
        fmt::format("no .mtl file has the material {}: light grey, opaque", some_of(unknown)));
  if (!textured.empty())
    remarks.push_back(
        fmt::format("materials say more than is read, textures are not: {} of the material {}",
                    materials.at(textured.front()).passed_over, some_of(textured)));
}

}  // namespace

std::vector<Rgba> obj_element_colors(const ObjDocument& document, const ObjElements& elements,
                                     std::vector<std::string>& remarks) {
  if (document.materials.empty()) return {};
  if (!document.colors.empty()) {
    remarks.push_back("its materials are passed over: the vertices have colours");
    return {};
  }
  const MtlMaterials materials = read_libraries(document, remarks);
  remark_materials(document, materials, remarks);
  bool has_some = false;
  std::vector<Rgba> colors;
  for (const std::uint32_t index : elements.materials) {
    const auto found =
        index == obj_none ? materials.end() : materials.find(document.materials[index]);
    const MtlMaterial material = found == materials.end() ? MtlMaterial() : found->second;
    has_some = has_some || found != materials.end();
    colors.emplace_back(material.color, material.opacity);
  }
  if (!has_some) colors.clear();
  return colors;
}

}  // namespace pellucid::geometry
