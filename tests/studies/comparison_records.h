// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

/// What the comparison of factorisations measured, kept in a file so that no fit is done twice.
namespace gonio::study {

/// One model of one material at one budget of bytes.
struct ComparisonRecord {
  std::string material, collection, model;
  int terms = 0;           ///< of the PDV model whose bytes are the budget; 0 for what is no model
  std::size_t bytes = 0;   ///< that the model has
  double rendered = 0;     ///< SNR of pictures, dB
  double peak = 0;         ///< PSNR of pictures, dB
  double reflectance = 0;  ///< SNR of reflectances, dB
  double seconds = 0;      ///< of the factorisation, with what budgets share
};

class ComparisonRecords {
 public:
  /// @param path of a CSV file: its records are taken over, new ones are appended at once. Empty: none is kept.
  /// @throws Error naming the file and the line.
  explicit ComparisonRecords(std::filesystem::path path);

  bool contains(const std::string& material, const std::string& model, int terms) const;
  /// @throws Error naming the file.
  void add(const ComparisonRecord& record);
  const std::vector<ComparisonRecord>& all() const { return records_; }

 private:
  std::filesystem::path path_;
  std::vector<ComparisonRecord> records_;
};

/// A Markdown table: a line a model and budget, means over the materials, and how many of them a model keeps best in
/// pictures among all models of that budget. Materials without a ratio (black ones) are left out.
std::string summaryTable(const std::vector<ComparisonRecord>& records);
/// A Markdown table: a line a material, a column a model, SNR of pictures at one budget.
std::string materialTable(const std::vector<ComparisonRecord>& records, int terms);

}  // namespace gonio::study
