// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QProcess>
#include <QStringList>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

/// What the tests of goniotool share: running it and reading its results.
namespace gonio::test {

struct ToolResult {
  int code = -1;
  QString out, error;
  nlohmann::json json;  ///< of standard output; null when that is none

  /// Lines on standard error.
  int errorLines() const { return int(error.count('\n')); }
};

/// Every key of results that runTool() has seen, but those whose names are data (metrics, parameters, angles).
inline std::set<std::string>& seenKeys() {
  static std::set<std::string> keys;
  return keys;
}

inline void collectKeys(const nlohmann::json& json) {
  static const std::set<std::string> holdData = {"errors", "parameters", "fitted", "edited", "albedo"};
  if (json.is_array())
    for (const nlohmann::json& element : json) collectKeys(element);
  if (!json.is_object()) return;
  for (const auto& [key, value] : json.items()) {
    seenKeys().insert(key);
    if (!holdData.contains(key)) collectKeys(value);
  }
}

/// Runs goniotool to its end.
inline ToolResult runTool(const QStringList& arguments) {
  QProcess process;
  process.start(GONIO_TOOL, arguments);
  process.closeWriteChannel();
  ToolResult result;
  if (!process.waitForFinished(120000)) return result;
  result.code = process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
  result.out = QString::fromUtf8(process.readAllStandardOutput());
  result.error = QString::fromUtf8(process.readAllStandardError());
  result.json = nlohmann::json::parse(result.out.toStdString(), nullptr, false);
  if (result.json.is_discarded()) result.json = nullptr;
  collectKeys(result.json);
  return result;
}

inline ToolResult runJson(QStringList arguments) { return runTool(arguments << "--json"); }

}  // namespace gonio::test
