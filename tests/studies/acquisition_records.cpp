// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "tests/studies/acquisition_records.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <set>

#include "core/support/error.h"
#include "tests/studies/study_files.h"

namespace gonio::study {

namespace {

constexpr char header[] = "material,collection,selection,reconstruction,samples,seed,rendered,linear,log-relative";

double medianOf(std::vector<double> values) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

std::string text(double value, int digits) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*f", digits, value);
  return buffer;
}

using Way = std::pair<std::string, std::string>;  // selection, reconstruction

}  // namespace

bool AcquisitionRecord::sameCase(const AcquisitionRecord& other) const {
  return material == other.material && selection == other.selection && reconstruction == other.reconstruction &&
         samples == other.samples && seed == other.seed;
}

AcquisitionRecords::AcquisitionRecords(std::filesystem::path path) : path_(std::move(path)) {
  std::ifstream file(path_);
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (number == 1 && line == header) continue;
    const std::vector<std::string> parts = split(line);
    if (parts.size() != 9) throw Error(path_.string() + ": line " + std::to_string(number) + " has not nine fields");
    records_.push_back({parts[0], parts[1], parts[2], parts[3], std::stoi(parts[4]), std::stoull(parts[5]),
                        std::stod(parts[6]), std::stod(parts[7]), std::stod(parts[8])});
  }
}

bool AcquisitionRecords::contains(const AcquisitionRecord& record) const {
  return std::ranges::any_of(records_, [&](const AcquisitionRecord& one) { return one.sameCase(record); });
}

void AcquisitionRecords::add(const AcquisitionRecord& record) {
  const bool begins = records_.empty();
  records_.push_back(record);
  std::ofstream file(path_, std::ios::app);
  if (begins) file << header << '\n';
  file << record.material << ',' << record.collection << ',' << record.selection << ',' << record.reconstruction << ','
       << record.samples << ',' << record.seed << ',' << record.rendered << ',' << record.linear << ','
       << record.logRelative << '\n';
  if (!file) throw Error("cannot write " + path_.string());
}

std::string AcquisitionRecords::table(double AcquisitionRecord::*value, int digits) const {
  std::map<Way, std::map<int, std::map<std::string, std::vector<double>>>> ways;
  std::set<int> counts;
  for (const AcquisitionRecord& one : records_)
    if (std::isfinite(one.*value)) {
      ways[{one.selection, one.reconstruction}][one.samples][one.material].push_back(one.*value);
      counts.insert(one.samples);
    }
  std::string head = "| directions | reconstruction |", rule = "|---|---|", lines;
  for (const int count : counts) {
    head += " m = " + std::to_string(count) + " |";
    rule += "---|";
  }
  for (const auto& [way, columns] : ways) {
    lines += "| " + way.first + " | " + way.second + " |";
    for (const int count : counts) {
      const auto column = columns.find(count);
      if (column == columns.end()) {
        lines += " - |";
        continue;
      }
      std::vector<double> means, spreads;
      for (const auto& [material, seeds] : column->second) {
        double sum = 0;
        for (const double one : seeds) sum += one;
        means.push_back(sum / double(seeds.size()));
        const auto [lowest, highest] = std::ranges::minmax(seeds);
        if (seeds.size() > 1) spreads.push_back(highest - lowest);
      }
      lines += " " + text(medianOf(means), digits);
      if (!spreads.empty()) lines += " (" + text(medianOf(spreads), digits) + ")";
      lines += " |";
    }
    lines += '\n';
  }
  return head + '\n' + rule + '\n' + lines;
}

std::string AcquisitionRecords::materials(int samples) const {
  std::map<std::string, std::map<Way, std::vector<double>>> rows;
  std::set<Way> ways;
  for (const AcquisitionRecord& one : records_)
    if (one.samples == samples) {
      rows[one.material][{one.selection, one.reconstruction}].push_back(one.rendered);
      ways.insert({one.selection, one.reconstruction});
    }
  std::string head = "| material |", rule = "|---|", lines;
  for (const auto& [selection, reconstruction] : ways) {
    head += " " + selection + ", " + reconstruction + " |";
    rule += "---|";
  }
  for (const auto& [material, columns] : rows) {
    lines += "| " + material + " |";
    for (const Way& way : ways) {
      const auto column = columns.find(way);
      lines += column == columns.end() ? " - |" : " " + text(medianOf(column->second), 1) + " |";
    }
    lines += '\n';
  }
  return head + '\n' + rule + '\n' + lines;
}

}  // namespace gonio::study
