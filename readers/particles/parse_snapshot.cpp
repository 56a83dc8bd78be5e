// SPDX-License-Identifier: GPL-3.0-or-later
// The layout is that of GADGET's user guide ("Format 3"), which AREPO, GIZMO and SWIFT share. Data
// sets are read one by one, and written as they are read.
#include "readers/particles/parse_snapshot.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cstdlib>
#include <limits>
#include <map>

#include "core/files/bad_file.h"
#include "readers/particles/hdf5_objects.h"

namespace pellucid::readers {
namespace {

constexpr std::string_view group_name = "PartType", position_name = "Coordinates";
constexpr hsize_t most_components = 9;

/// The number of "PartType0", …; nothing for other names.
std::optional<int> type_of(std::string_view name) {
  if (!name.starts_with(group_name)) return std::nullopt;
  name.remove_prefix(group_name.size());
  int number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (error != std::errc() || end != name.data() + name.size()) return std::nullopt;
  return number;
}

/// The particles of one type.
struct ParticleType {
  int number;
  Hdf5Object group;
  hsize_t count;
  std::map<std::string, hsize_t> columns;  // components by name
  double mass;                             // of each, where the head keeps it; else 0
};

class Snapshot {
 public:
  explicit Snapshot(const std::filesystem::path& path)
      : path_(path), file_(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose) {
    if (!file_) bad_file(path_, "it is no HDF5 file, or a damaged one");
    const Hdf5Object head(H5Oopen(file_.id(), "Header", H5P_DEFAULT), H5Oclose);
    const std::vector<double> masses = attribute_numbers(head.id(), "MassTable");
    const std::vector<double> files = attribute_numbers(head.id(), "NumFilesPerSnapshot");
    for (const std::string& name : names_in(file_.id()))
      if (const auto number = type_of(name)) add_type(*number, name, masses);
    if (types_.empty()) fail_without_particles();
    if (files.size() == 1 && files[0] > 1)
      remark("it is one of {:.0f} files of its snapshot: the others' particles are not read",
             files[0]);
  }

  void write(BlockWriter& out) {
    out.begin("positions", NumberType::f64, 3, count());
    for (const ParticleType& type : types_) append(type, std::string(position_name), out);
    for (const auto& [name, components] : columns()) write_column(name, components, out);
    if (types_.size() > 1) write_types(out);
    out.add_text("remarks", remarks_);
  }

 private:
  template <class... Values>
  void remark(fmt::format_string<Values...> text, Values&&... values) {
    remarks_ += fmt::format(text, std::forward<Values>(values)...) + "\n";
  }

  void add_type(int number, const std::string& name, const std::vector<double>& masses) {
    Hdf5Object group(H5Oopen(file_.id(), name.c_str(), H5P_DEFAULT), H5Oclose);
    const auto positions = open_numbers(group.id(), std::string(position_name));
    if (!positions || positions->rows == 0) return;
    if (positions->components != 3)
      bad_file(path_, fmt::format("{}/{} has {} components; accepted: 3", name, position_name,
                                  positions->components));
    ParticleType type{number, std::move(group), positions->rows, {}, 0};
    for (const std::string& column : names_in(type.group.id())) add_column(name, column, type);
    const bool in_table = number >= 0 && std::size_t(number) < masses.size();
    if (in_table && !type.columns.contains("Masses")) type.mass = masses[std::size_t(number)];
    types_.push_back(std::move(type));
  }

  void add_column(const std::string& group, const std::string& name, ParticleType& type) {
    const auto numbers = open_numbers(type.group.id(), name);
    if (!numbers) return remark("'{}/{}' is no table of numbers: it is left out", group, name);
    if (numbers->elsewhere)
      bad_file(path_, fmt::format("{}/{} is kept in other files; accepted: data in the file itself",
                                  group, name));
    if (name == position_name) return;
    if (numbers->rows != type.count || numbers->components > most_components)
      return remark("'{}/{}' ({} x {}) is left out: there are {} particles", group, name,
                    numbers->rows, numbers->components, type.count);
    type.columns[name] = numbers->components;
  }

  [[noreturn]] void fail_without_particles() const {
    bad_file(path_, fmt::format("it has no particles: none of the groups PartType0, PartType1, … "
                                "with {}; it holds: {}",
                                position_name, fmt::join(names_in(file_.id()), ", ")));
  }

  hsize_t count() const {
    hsize_t count = 0;
    for (const ParticleType& type : types_) count += type.count;
    return count;
  }

  /// The columns of any type with their components.
  std::map<std::string, hsize_t> columns() {
    std::map<std::string, hsize_t> all;
    for (const ParticleType& type : types_) {
      all.insert(type.columns.begin(), type.columns.end());
      if (type.mass > 0) all.emplace("Masses", 1);
    }
    std::erase_if(all, [&](const auto& column) {
      for (const ParticleType& type : types_)
        if (const auto own = type.columns.find(column.first);
            own != type.columns.end() && own->second != column.second) {
          remark("'{}' is left out: types of particles have other numbers of it", column.first);
          return true;
        }
      return false;
    });
    return all;
  }

  void append(const ParticleType& type, const std::string& name, BlockWriter& out) const {
    const auto numbers = open_numbers(type.group.id(), name);
    const auto values = numbers ? read_numbers(*numbers) : std::nullopt;
    if (!values) bad_file(path_, fmt::format("{}{}/{} is damaged", group_name, type.number, name));
    out.append(values->data(), values->size() * sizeof(double));
  }

  static void append_all(const ParticleType& type, double value, hsize_t components,
                         BlockWriter& out) {
    const std::vector<double> values(type.count * components, value);
    out.append(values.data(), values.size() * sizeof(double));
  }

  void write_column(const std::string& name, hsize_t components, BlockWriter& out) {
    out.begin("column:" + name, NumberType::f64, std::uint32_t(components), count());
    std::vector<int> without;
    for (const ParticleType& type : types_) {
      const bool of_table = name == "Masses" && type.mass > 0;
      if (type.columns.contains(name)) {
        append(type, name, out);
      } else {
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        append_all(type, of_table ? type.mass : none, components, out);
        if (!of_table) without.push_back(type.number);
      }
    }
    if (!without.empty())
      remark("'{}' is not there for particles of type {}: it is NaN", name,
             fmt::join(without, ", "));
  }

  void write_types(BlockWriter& out) const {
    out.begin("column:particle_type", NumberType::f64, 1, count());
    for (const ParticleType& type : types_) append_all(type, type.number, 1, out);
  }

  const std::filesystem::path& path_;
  Hdf5Object file_;
  std::vector<ParticleType> types_;
  std::string remarks_;
};

}  // namespace

void parse_snapshot(const std::filesystem::path& path, BlockWriter& out) {
  // A file that is read needs no lock, which some networks' folders do not have.
  setenv("HDF5_USE_FILE_LOCKING", "FALSE", 0);
  H5Eset_auto(H5E_DEFAULT, nullptr, nullptr);
  Snapshot(path).write(out);
}

}  // namespace pellucid::readers
