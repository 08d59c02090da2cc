// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/learned_basis.h"

#include <algorithm>
#include <chrono>
#include <optional>

#include "core/documents/open_material.h"
#include "core/io/atomic_file.h"
#include "core/io/sha256.h"
#include "core/materials/bundled_library.h"
#include "core/study/training_files.h"
#include "core/support/system.h"

namespace gonio::study {

namespace {

namespace fs = std::filesystem;

/// Changes with the meaning of a kept basis.
constexpr int generation = 1;

/// The means of both orders of the directions cover half a circle of phi_d.
HalfDifferenceGrid gridOfMeans(const HalfDifferenceGrid& grid) {
  return {grid.thetaHCount, grid.thetaDCount, grid.reciprocal ? grid.phiDCount : grid.phiDCount / 2, true};
}

/// What identifies a training material without reading it; empty where nothing does.
std::string identityOf(const std::string& file) {
  if (file.starts_with(materials::libraryScheme)) return materials::librarySha256(file);
  if (documents::isDocument(file)) return {};
  std::error_code failed;
  const fs::path path = fs::canonical(file, failed);
  if (failed) return {};
  const auto size = fs::file_size(path, failed);
  if (failed) return {};
  const auto time = fs::last_write_time(path, failed).time_since_epoch().count();
  return failed ? std::string() : path.string() + " " + std::to_string(size) + " " + std::to_string(time);
}

/// Empty where the training set cannot be identified.
std::string keyOf(const std::vector<std::string>& files, int components, materials::BasisPrecision precision) {
  std::string text = std::to_string(generation) + " " + std::to_string(components) + " " +
                     (precision == materials::BasisPrecision::half ? "half" : "single");
  for (const std::string& file : files) {
    const std::string identity = identityOf(file);
    if (identity.empty()) return {};
    text += "\n" + fs::path(file).stem().string() + " " + identity;
  }
  return io::sha256Hex(text).substr(0, 32);
}

/// The kept file of a key: KEY-DIGEST.basis. The digest shows whether it still is what was kept. Others are written to
/// at present, by another process.
fs::path keptFile(const std::string& key) {
  std::error_code failed;
  fs::directory_iterator entries(keptBasesFolder(), failed);
  for (; !failed && entries != fs::directory_iterator(); entries.increment(failed)) {
    const fs::path& file = entries->path();
    if (file.filename().string().starts_with(key) && file.extension() == materials::basisSuffix) return file;
  }
  return {};
}

std::string digestIn(const fs::path& file) {
  const std::string stem = file.stem().string();
  return stem.substr(std::min(stem.size(), stem.find('-') + 1));
}

std::optional<LearnedBasis> kept(const std::string& key, const TaskControl& control) {
  const fs::path file = keptFile(key);
  if (file.empty()) return std::nullopt;
  std::error_code failed;
  try {
    const std::vector<std::byte> bytes = io::FileSource(file).readAll();
    control.throwIfStopped();
    const std::string digest = io::sha256Hex(bytes);
    if (digest == digestIn(file)) {
      LearnedBasis result{.basis = materials::readBasis(io::MemorySource(bytes)), .file = file, .digest = digest};
      fs::last_write_time(file, fs::file_time_type::clock::now(), failed);
      return result;
    }
  } catch (const Cancelled&) {
    throw;
  } catch (const Error&) {
    // Unreadable, as if it had not been kept.
  }
  fs::remove(file, failed);
  return std::nullopt;
}

/// Removes what was not used for the longest time.
void removeOldest(const fs::path& folder) {
  std::error_code failed;
  std::vector<fs::directory_entry> entries;
  std::uint64_t total = 0;
  for (const auto& entry : fs::directory_iterator(folder, failed)) {
    if (!entry.is_regular_file(failed)) continue;
    entries.push_back(entry);
    total += entry.file_size(failed);
  }
  std::ranges::sort(entries, {}, [&](const fs::directory_entry& entry) { return entry.last_write_time(failed); });
  for (const fs::directory_entry& entry : entries) {
    if (total <= maxKeptBytes) return;
    total -= entry.file_size(failed);
    fs::remove(entry.path(), failed);
  }
}

/// Where the file cannot be kept, the path is empty: that costs time and nothing else.
fs::path keep(const std::string& key, const std::string& digest, std::span<const std::byte> bytes) {
  const fs::path folder = keptBasesFolder();
  if (key.empty() || folder.empty() || bytes.size() > maxKeptBytes) return {};
  try {
    fs::create_directories(folder);
    const fs::path file = folder / (key + "-" + digest + std::string(materials::basisSuffix));
    io::writeFileAtomically(file, bytes);
    // Plans refer to it by hard links: nobody may write into it.
    constexpr auto written = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
    fs::permissions(file, written, fs::perm_options::remove);
    removeOldest(folder);
    return file;
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace

fs::path keptBasesFolder() {
  const fs::path cache = system::cacheFolder();
  return cache.empty() ? fs::path() : cache / "gonio" / "bases";
}

LearnedBasis learnedBasis(const std::vector<std::string>& files, int components, materials::BasisPrecision precision,
                          const TaskControl& control) {
  const std::string key = keyOf(files, components, precision);
  if (!key.empty())
    if (auto known = kept(key, control)) return *known;
  const auto start = std::chrono::steady_clock::now();
  const auto training = trainingMaterials(files, gridOfMeans(trainingGrid(files)));
  const auto learned = dictionary::learnPrincipalComponents(training.names.size(), training.load,
                                                            {.maxComponents = components}, control);
  const std::vector<std::byte> bytes = materials::encodeBasis(learned, components, training.names, precision);
  LearnedBasis result{.digest = io::sha256Hex(bytes)};
  result.basis = materials::readBasis(io::MemorySource(bytes));
  result.file = keep(key, result.digest, bytes);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace gonio::study
