// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// What reconstructions from few samples measured, kept in a file so that none is done twice.
namespace gonio::study {

/// One material from one choice of samples by one way to reconstruct.
struct AcquisitionRecord {
  std::string material, collection;
  std::string selection;       ///< "somp", "condition-number", ...
  std::string reconstruction;  ///< "ridge-40", "ridge-auto", ...
  int samples = 0;
  std::uint64_t seed = 0;
  double rendered = 0;     ///< SNR of pictures, dB
  double linear = 0;       ///< 1 / mean square of the reflectance's error, sr^2
  double logRelative = 0;  ///< 1 / mean square of the error of ln(rho cos cos + 0.001)

  /// Whether it is the same case: all but what was measured.
  bool sameCase(const AcquisitionRecord& other) const;
};

class AcquisitionRecords {
 public:
  /// @param path of a CSV file: its records are taken over, new ones are appended at once.
  /// @throws Error naming the file and the line.
  explicit AcquisitionRecords(std::filesystem::path path);

  bool contains(const AcquisitionRecord& record) const;
  /// @throws Error naming the file.
  void add(const AcquisitionRecord& record);

  /// A Markdown table: a line per selection and reconstruction, a column per number of samples: medians over the
  /// materials of the means over the seeds, with the median over the materials of the spread (largest less smallest) of
  /// seeds.
  std::string table(double AcquisitionRecord::*value, int digits) const;
  /// A Markdown table of one number of samples: a line per material, a column per selection and reconstruction;
  /// rendered SNR.
  std::string materials(int samples) const;

 private:
  std::filesystem::path path_;
  std::vector<AcquisitionRecord> records_;
};

}  // namespace gonio::study
