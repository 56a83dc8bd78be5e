// SPDX-License-Identifier: GPL-3.0-or-later
// What VTK's readers of NetCDF and MRC leave to their caller: missing samples, scales, signs.

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <limits>

#include "core/files/output_file.h"
#include "tests/readers/simulations/read_files.h"

namespace pellucid::readers {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsNan;

class UnitScaledValues : public ReadFiles {
 protected:
  /// A file of 2 × 2 × 2 samples q: the four that are given, and then ones.
  std::filesystem::path netcdf(nc_type type, std::vector<double> samples,
                               const std::function<void(int file, int q)>& describe) const {
    const auto path = folder_ / "q.nc";
    samples.resize(8, 1);
    int file = 0, dims[3], q = 0;
    nc_create(path.c_str(), NC_CLOBBER, &file);
    for (int a = 0; a < 3; ++a) {
      int axis = 0;
      const char name[] = {"zyx"[a], 0};
      nc_def_dim(file, name, 2, &dims[a]);
      nc_def_var(file, name, NC_DOUBLE, 1, &dims[a], &axis);
    }
    nc_def_var(file, "q", type, 3, dims, &q);
    describe(file, q);
    nc_enddef(file);
    const double ends[] = {0, 1};
    for (int axis = 0; axis < 3; ++axis) nc_put_var_double(file, axis, ends);
    EXPECT_EQ(nc_put_var_double(file, q, samples.data()), NC_NOERR);
    nc_close(file);
    return path;
  }

  /// An MRC map of 2 × 2 × 2 samples whose bytes are `data`.
  std::filesystem::path mrc(std::int32_t mode, const std::string& data,
                            std::int32_t version = 20141,
                            std::array<std::int32_t, 3> axes = {1, 2, 3}) const {
    std::string bytes(1024, '\0');
    const auto put = [&](std::size_t at, auto number) {
      std::memcpy(&bytes[at], &number, sizeof number);
    };
    for (std::size_t k = 0; k < 3; ++k) {
      put(4 * k, std::int32_t(2)), put(28 + 4 * k, std::int32_t(2)), put(40 + 4 * k, 2.0f);
      put(64 + 4 * k, axes[k]);
    }
    put(12, mode), put(108, version);
    std::memcpy(&bytes[208], "MAP DA", 6);
    write_text(folder_ / "m.mrc", bytes + data);
    return folder_ / "m.mrc";
  }

  /// The same map, the largest byte of each number of 32 bits first.
  std::filesystem::path big_endian_mrc(std::string data) const {
    std::string bytes = read_text(mrc(2, data));
    for (std::size_t at = 0; at + 4 <= bytes.size(); at += 4)
      if (at < 96 || at == 108 || at >= 1024)
        std::reverse(bytes.begin() + long(at), bytes.begin() + long(at + 4));
    bytes[212] = bytes[213] = 0x11;
    write_text(folder_ / "m.mrc", bytes);
    return folder_ / "m.mrc";
  }
};

std::string bytes_of(const std::vector<float>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(float)};
}

void put(int file, int q, const char* name, nc_type type, std::vector<double> values) {
  EXPECT_EQ(nc_put_att_double(file, q, name, type, values.size(), values.data()), NC_NOERR);
}

TEST_F(UnitScaledValues, MissingSamplesOfNetcdfByAttribute) {
  const std::vector<double> samples{-999, 5, 100, 7};
  for (const nc_type type : {NC_FLOAT, NC_DOUBLE, NC_SHORT, NC_INT})
    for (const char* fill : {"_FillValue", "missing_value"})
      EXPECT_THAT(
          values(netcdf(type, samples, [&](int file, int q) { put(file, q, fill, type, {-999}); }),
                 4),
          ElementsAre(IsNan(), 5, 100, 7))
          << fill << " of type " << type;
  const auto of = [&](const char* name, std::vector<double> ends) {
    return values(
        netcdf(NC_FLOAT, samples, [&](int file, int q) { put(file, q, name, NC_FLOAT, ends); }), 4);
  };
  EXPECT_THAT(of("missing_value", {100, 7}), ElementsAre(-999, 5, IsNan(), IsNan()));
  EXPECT_THAT(of("valid_min", {5}), ElementsAre(IsNan(), 5, 100, 7));
  EXPECT_THAT(of("valid_max", {7}), ElementsAre(-999, 5, IsNan(), 7));
  EXPECT_THAT(of("valid_range", {5, 7}), ElementsAre(IsNan(), 5, IsNan(), 7));
}

/// 0.1 has no exact float: an attribute of doubles still means the sample of floats.
TEST_F(UnitScaledValues, AnAttributeOfAnotherTypeMeansTheSample) {
  EXPECT_THAT(
      values(netcdf(NC_FLOAT, {0.1, 2},
                    [](int file, int q) { put(file, q, "missing_value", NC_DOUBLE, {0.1}); }),
             2),
      ElementsAre(IsNan(), 2));
}

TEST_F(UnitScaledValues, SamplesThatWereNeverWritten) {
  const auto plain = [](int, int) {};
  EXPECT_THAT(values(netcdf(NC_FLOAT, {NC_FILL_FLOAT, 2}, plain), 2), ElementsAre(IsNan(), 2));
  EXPECT_THAT(values(netcdf(NC_DOUBLE, {NC_FILL_DOUBLE, 2}, plain), 2), ElementsAre(IsNan(), 2));
  EXPECT_THAT(values(netcdf(NC_SHORT, {-32767, 2}, plain), 2), ElementsAre(IsNan(), 2));
  EXPECT_THAT(values(netcdf(NC_INT, {-2147483647, 2}, plain), 2), ElementsAre(IsNan(), 2));
  EXPECT_THAT(values(netcdf(NC_SHORT, {-32767, -1, 2},
                            [](int file, int q) { put(file, q, "_FillValue", NC_SHORT, {-1}); }),
                     3),
              ElementsAre(-32767, IsNan(), 2));  // who names a value of his own has no other
}

/// q = packed / 10 + 300. A valid range of the packed type is packed, of a wider one it is not.
TEST_F(UnitScaledValues, PackedSamples) {
  const auto packed = [&](nc_type range_type, std::vector<double> range, double scale = 0.1) {
    return values(netcdf(NC_SHORT, {-32767, 10, 20, 30},
                         [&](int file, int q) {
                           put(file, q, "scale_factor", NC_DOUBLE, {scale});
                           put(file, q, "add_offset", NC_DOUBLE, {300});
                           if (!range.empty()) put(file, q, "valid_range", range_type, range);
                         }),
                  4);
  };
  EXPECT_THAT(packed(NC_SHORT, {}), ElementsAre(IsNan(), 301, 302, 303));
  EXPECT_THAT(packed(NC_SHORT, {10, 20}), ElementsAre(IsNan(), 301, 302, IsNan()));
  EXPECT_THAT(packed(NC_DOUBLE, {302, 303}), ElementsAre(IsNan(), IsNan(), 302, 303));
  EXPECT_THAT(packed(NC_SHORT, {10, 20}, -0.1), ElementsAre(IsNan(), 299, 298, IsNan()));
}

/// q = packed / 2 + 10, of bytes with a sign.
TEST_F(UnitScaledValues, PackedBytes) {
  EXPECT_THAT(values(netcdf(NC_BYTE, {-128, -1, 0, 127},
                            [](int file, int q) {
                              put(file, q, "scale_factor", NC_DOUBLE, {0.5});
                              put(file, q, "add_offset", NC_DOUBLE, {10});
                              put(file, q, "_FillValue", NC_BYTE, {-1});
                            }),
                     4),
              ElementsAre(-54, IsNan(), 10, 73.5));
}

TEST_F(UnitScaledValues, NumbersCalledUnsignedAreRefused) {
  EXPECT_THAT(
      complaint(netcdf(NC_SHORT, {1},
                       [](int file, int q) { nc_put_att_text(file, q, "_Unsigned", 4, "true"); })),
      HasSubstr("'q' has the attribute _Unsigned"));
}

TEST_F(UnitScaledValues, BytesOfMrcAreSignedWhereTheFormatSaysSo) {
  const std::string bytes = "\xFE\xFF\x01\x02\x03\x04\x05\x06";
  EXPECT_THAT(values(mrc(0, bytes), 3), ElementsAre(-2, -1, 1));
  EXPECT_THAT(values(mrc(0, bytes, 0), 3), ElementsAre(254, 255, 1));  // older programs' bytes
  EXPECT_THAT(values(mrc(0, bytes, 0, {0, 0, 0}), 3), ElementsAre(254, 255, 1));
}

TEST_F(UnitScaledValues, MrcWithTheLargestByteFirst) {
  EXPECT_THAT(values(big_endian_mrc(bytes_of({1, 2, 3.5, -4, 5, 6, 7, 8e9})), 8),
              ElementsAre(1, 2, 3.5, -4, 5, 6, 7, float(8e9)));
  std::string unsaid = read_text(folder_ / "m.mrc");
  unsaid[212] = 0;
  write_text(folder_ / "m.mrc", unsaid);
  EXPECT_THAT(complaint(folder_ / "m.mrc"), HasSubstr("byte 213, the machine stamp, is not 17"));
}

TEST_F(UnitScaledValues, MrcThatWasCutOffIsRefused) {
  EXPECT_THAT(complaint(mrc(2, bytes_of({1, 2, 3, 4, 5, 6, 7}))),
              HasSubstr("28 bytes of samples, but its 8 samples take 32; truncated?"));
}

TEST_F(UnitScaledValues, MrcWithSlantedAxesIsRefused) {
  std::string slanted = read_text(mrc(2, std::string(32, '\0')));
  const float angle = 120;
  std::memcpy(&slanted[60], &angle, sizeof angle);
  write_text(folder_ / "m.mrc", slanted);
  EXPECT_THAT(complaint(folder_ / "m.mrc"), HasSubstr("an angle between its axes is 120°"));
}

TEST_F(UnitScaledValues, MrcThatVtkReadsOtherwiseIsRefused) {
  EXPECT_THAT(complaint(mrc(6, std::string(16, '\1'))), HasSubstr("mode 6, unsigned numbers"));
  EXPECT_THAT(complaint(mrc(12, std::string(16, '\1'))), HasSubstr("mode 12; accepted"));
  EXPECT_THAT(complaint(mrc(2, std::string(32, '\0'), 20141, {3, 2, 1})),
              HasSubstr("the axes 3, 2, 1; accepted: 1, 2, 3"));
  EXPECT_EQ(complaint(mrc(2, std::string(32, '\0'))), "no complaint");
}

}  // namespace
}  // namespace pellucid::readers
