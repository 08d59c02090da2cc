// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

/// What comparisons of models measured, kept in a file so that no fit is done twice.
namespace gonio::study {

/// One model of one material at one budget of bytes.
struct ComparisonRecord {
  std::string material, collection, model;
  /// Of the model whose bytes are the budget: terms of PDV factors, or coefficients a channel of a code; 0 for what is
  /// no model.
  int terms = 0;
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

  /// Null where there is none.
  const ComparisonRecord* find(const std::string& material, const std::string& model, int terms) const;
  bool contains(const std::string& material, const std::string& model, int terms) const {
    return find(material, model, terms) != nullptr;
  }
  /// Where there is one of the same material, model and budget, it stays. @throws Error naming the file.
  void add(const ComparisonRecord& record);
  const std::vector<ComparisonRecord>& all() const { return records_; }

 private:
  std::filesystem::path path_;
  std::vector<ComparisonRecord> records_;
};

/// A Markdown table: a line per model and budget, means over the materials, and how many of them a model keeps best in
/// pictures among all models of that budget. Materials without a ratio (black ones) are left out.
/// @param budget heads the column of budgets.
std::string summaryTable(const std::vector<ComparisonRecord>& records, const std::string& budget = "L");
/// A Markdown table: for every budget a line per model but `ours`: over the materials that both have, the means of ours
/// and of theirs, the mean and the median of what ours is ahead by, and on how many it is ahead, equal and behind.
std::string aheadTable(const std::vector<ComparisonRecord>& records, const std::string& ours,
                       const std::string& budget = "L");
/// A Markdown table: a line per material, a column per model, SNR of pictures at one budget.
std::string materialTable(const std::vector<ComparisonRecord>& records, int terms);

}  // namespace gonio::study
