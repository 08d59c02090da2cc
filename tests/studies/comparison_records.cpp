// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "tests/studies/comparison_records.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numeric>
#include <set>
#include <sstream>

#include "core/support/error.h"

namespace gonio::study {

namespace {

constexpr char columnNames[] = "material,collection,model,terms,bytes,rendered_snr,rendered_psnr,brdf_snr,seconds";

std::string lineOf(const ComparisonRecord& r) {
  char numbers[160];
  std::snprintf(numbers, sizeof numbers, "%d,%zu,%.4f,%.4f,%.4f,%.3f", r.terms, r.bytes, r.rendered, r.peak,
                r.reflectance, r.seconds);
  return r.material + ',' + r.collection + ',' + r.model + ',' + numbers;
}

ComparisonRecord parse(const std::string& line) {
  std::istringstream stream(line);
  ComparisonRecord r;
  for (std::string* text : {&r.material, &r.collection, &r.model}) std::getline(stream, *text, ',');
  std::vector<double> numbers;
  for (std::string cell; std::getline(stream, cell, ',');) numbers.push_back(std::stod(cell));
  if (numbers.size() != 6) throw Error("found " + std::to_string(numbers.size()) + " numbers, expected 6");
  r.terms = int(numbers[0]);
  r.bytes = std::size_t(numbers[1]);
  r.rendered = numbers[2];
  r.peak = numbers[3];
  r.reflectance = numbers[4];
  r.seconds = numbers[5];
  return r;
}

using Records = std::vector<ComparisonRecord>;

/// In the order in which they come first.
std::vector<std::string> distinct(const Records& records, std::string ComparisonRecord::*member) {
  std::vector<std::string> names;
  for (const ComparisonRecord& r : records)
    if (std::ranges::find(names, r.*member) == names.end()) names.push_back(r.*member);
  return names;
}

template <typename Keep>
Records select(const Records& records, Keep keep) {
  Records chosen;
  for (const ComparisonRecord& r : records)
    if (std::isfinite(r.rendered) && std::isfinite(r.reflectance) && keep(r)) chosen.push_back(r);
  return chosen;
}

double mean(const Records& records, double ComparisonRecord::*member) {
  const double sum = std::accumulate(records.begin(), records.end(), 0.0,
                                     [member](double s, const ComparisonRecord& r) { return s + r.*member; });
  return records.empty() ? std::nan("") : sum / double(records.size());
}

double median(std::vector<double> values) {
  if (values.empty()) return std::nan("");
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 ? values[half] : (values[half - 1] + values[half]) / 2;
}

double medianRendered(const Records& records) {
  std::vector<double> values;
  for (const ComparisonRecord& r : records) values.push_back(r.rendered);
  return median(std::move(values));
}

int wins(const Records& ofModel, const Records& ofBudget) {
  return int(std::ranges::count_if(ofModel, [&](const ComparisonRecord& mine) {
    return std::ranges::none_of(ofBudget, [&](const ComparisonRecord& other) {
      return other.material == mine.material && other.rendered > mine.rendered;
    });
  }));
}

/// Empty where there is none.
std::string cell(double decibels) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", decibels);
  return std::isfinite(decibels) ? text : "";
}

std::string summaryLine(const std::string& model, int terms, const Records& ofModel, const Records& ofBudget) {
  const auto of = [&](const std::string& collection) {
    return cell(
        mean(select(ofModel, [&](const auto& r) { return r.collection == collection; }), &ComparisonRecord::rendered));
  };
  std::size_t bytes = 0;
  for (const ComparisonRecord& r : ofModel) bytes = std::max(bytes, r.bytes);
  char kilobytes[32] = "";
  if (bytes > 0) std::snprintf(kilobytes, sizeof kilobytes, "%.1f", double(bytes) / 1000);
  const auto worst = std::ranges::min_element(ofModel, {}, &ComparisonRecord::rendered);
  const std::string budget = terms > 0 ? std::to_string(terms) : "",
                    best = terms > 0 ? std::to_string(wins(ofModel, ofBudget)) : "";
  std::string line;
  for (const std::string& text :
       {model, budget, std::string(kilobytes), of("MERL"), of("RGL"), cell(mean(ofModel, &ComparisonRecord::rendered)),
        cell(medianRendered(ofModel)), cell(worst->rendered) + " (" + worst->material + ")",
        cell(mean(ofModel, &ComparisonRecord::peak)), cell(mean(ofModel, &ComparisonRecord::reflectance)), best,
        cell(mean(ofModel, &ComparisonRecord::seconds))})
    line += "| " + text + ' ';
  return line + "|\n";
}

std::string aheadLine(const std::string& model, const Records& mine, const Records& theirs) {
  std::vector<double> differences;
  double ours = 0, baselines = 0;
  for (const ComparisonRecord& their : theirs) {
    const auto my = std::ranges::find(mine, their.material, &ComparisonRecord::material);
    if (my == mine.end()) continue;
    differences.push_back(my->rendered - their.rendered);
    ours += my->rendered;
    baselines += their.rendered;
  }
  if (differences.empty()) return {};
  const double count = double(differences.size());
  char line[200];
  std::snprintf(line, sizeof line, "| %d | %s | %.0f | %.2f | %.2f | %.2f | %.2f | %td | %td | %td |\n",
                theirs.front().terms, model.c_str(), count, ours / count, baselines / count, (ours - baselines) / count,
                median(differences), std::ranges::count_if(differences, [](double d) { return d > 0; }),
                std::ranges::count(differences, 0.0),
                std::ranges::count_if(differences, [](double d) { return d < 0; }));
  return line;
}

}  // namespace

ComparisonRecords::ComparisonRecords(std::filesystem::path path) : path_(std::move(path)) {
  std::ifstream file(path_);
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (line.empty() || line == columnNames) continue;
    try {
      records_.push_back(parse(line));
    } catch (const std::exception& error) {
      throw Error(path_.string() + ", line " + std::to_string(number) + ": " + error.what());
    }
  }
}

const ComparisonRecord* ComparisonRecords::find(const std::string& material, const std::string& model,
                                                int terms) const {
  const auto found = std::ranges::find_if(
      records_, [&](const auto& r) { return r.material == material && r.model == model && r.terms == terms; });
  return found == records_.end() ? nullptr : &*found;
}

void ComparisonRecords::add(const ComparisonRecord& record) {
  if (contains(record.material, record.model, record.terms)) return;
  if (!path_.empty()) {
    const bool isNew = !std::filesystem::exists(path_);
    std::ofstream file(path_, std::ios::app);
    if (isNew) file << columnNames << '\n';
    file << lineOf(record) << '\n';
    if (!file.flush()) throw Error(path_.string() + ": cannot be written");
  }
  records_.push_back(record);
}

std::string summaryTable(const Records& records, const std::string& budget) {
  std::string table =
      "| model | " + budget +
      " | KB | SNR, MERL | SNR, RGL | SNR, all | median | worst | PSNR, all | BRDF SNR, all | best | s |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  std::set<int> budgets;
  for (const ComparisonRecord& r : records) budgets.insert(r.terms);
  for (const int terms : budgets) {
    const Records ofBudget = select(records, [terms](const auto& r) { return r.terms == terms; });
    for (const std::string& model : distinct(records, &ComparisonRecord::model)) {
      const Records ofModel = select(ofBudget, [&](const auto& r) { return r.model == model; });
      if (!ofModel.empty()) table += summaryLine(model, terms, ofModel, ofBudget);
    }
  }
  return table;
}

std::string aheadTable(const Records& records, const std::string& ours, const std::string& budget) {
  std::string table = "| " + budget +
                      " | model | materials | ours | theirs | ahead by, mean | median | ahead | equal | behind |\n"
                      "|---|---|---|---|---|---|---|---|---|---|\n";
  std::set<int> budgets;
  for (const ComparisonRecord& r : records) budgets.insert(r.terms);
  for (const int terms : budgets) {
    const Records ofBudget = select(records, [terms](const auto& r) { return r.terms == terms; });
    const Records mine = select(ofBudget, [&](const auto& r) { return r.model == ours; });
    for (const std::string& model : distinct(ofBudget, &ComparisonRecord::model))
      if (model != ours)
        table += aheadLine(model, mine, select(ofBudget, [&](const auto& r) { return r.model == model; }));
  }
  return table;
}

std::string materialTable(const Records& records, int terms) {
  const std::vector<std::string> models = distinct(records, &ComparisonRecord::model);
  std::string table = "| material |", rule = "|---|";
  for (const std::string& model : models) {
    table += ' ' + model + " |";
    rule += "---|";
  }
  table += '\n' + rule + '\n';
  for (const std::string& material : distinct(records, &ComparisonRecord::material)) {
    table += "| " + material + " |";
    for (const std::string& model : models) {
      const auto found = std::ranges::find_if(records, [&](const auto& r) {
        return r.material == material && r.model == model && (r.terms == terms || r.terms == 0);
      });
      char text[32] = " |";
      if (found != records.end()) std::snprintf(text, sizeof text, " %.1f |", found->rendered);
      table += text;
    }
    table += '\n';
  }
  return table;
}

}  // namespace gonio::study
