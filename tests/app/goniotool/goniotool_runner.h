// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <sys/resource.h>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QStringList>
#include <csignal>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "core/materials/material.h"
#include "core/models/model.h"
#include "tests/support/leading_parameters.h"
#include "tests/support/table_file.h"

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

/// The keys that runTool() has seen and docs/command-line.md does not contain in backquotes, with what to do; empty if
/// there are none.
inline QString undocumentedKeys() {
  QFile page(QString(GONIO_DOCUMENTATION_DIR) + "/command-line.md");
  if (!page.open(QIODevice::ReadOnly)) return page.fileName() + " cannot be read";
  const QByteArray text = page.readAll();
  QStringList missing;
  for (const std::string& key : seenKeys())
    if (!text.contains("`" + QByteArray::fromStdString(key) + "`")) missing << QString::fromStdString(key);
  return missing.isEmpty() ? QString() : "document these keys in docs/command-line.md: " + missing.join(", ");
}

/// Runs goniotool to its end, for as long as CTest lets the test run. @param maxFileBytes limits the files that it may
/// write, as ulimit -f.
inline ToolResult runTool(const QStringList& arguments, rlim_t maxFileBytes = RLIM_INFINITY) {
  QProcess process;
  if (maxFileBytes != RLIM_INFINITY)
    process.setChildProcessModifier([maxFileBytes] {
      const rlimit limit{maxFileBytes, maxFileBytes};
      ::setrlimit(RLIMIT_FSIZE, &limit);
      std::signal(SIGXFSZ, SIG_DFL);  // Python, for one, starts programs with the signal ignored
    });
  process.start(GONIO_TOOL, arguments);
  process.closeWriteChannel();
  ToolResult result;
  constexpr int noLimit = -1;
  if (!process.waitForFinished(noLimit)) return result;
  result.code = process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
  result.out = QString::fromUtf8(process.readAllStandardOutput());
  result.error = QString::fromUtf8(process.readAllStandardError());
  result.json = nlohmann::json::parse(result.out.toStdString(), nullptr, false);
  if (result.json.is_discarded()) result.json = nullptr;
  collectKeys(result.json);
  return result;
}

/// A page of docs with its tables, as the build completes it. @param name e.g. "exports".
inline QString completePage(const QString& name) {
  return runTool({"--complete-page", QString(GONIO_DOCUMENTATION_DIR) + "/" + name + ".md"}).out;
}

inline ToolResult runJson(QStringList arguments) { return runTool(arguments << "--json"); }

/// Small enough that a test writes and fits many.
inline constexpr HalfDifferenceGrid smallGrid{.thetaHCount = 30, .thetaDCount = 30, .phiDCount = 36};
inline const models::ParameterValues plastic{{Rgb(0.05, 0.2, 0.3), Rgb(0.9, 0.8, 0.7), Rgb(0.15), Rgb(0.1), Rgb(0)}};

/// The files of one test program: an empty folder of its own.
class TestFolder {
 public:
  explicit TestFolder(const QString& name) : path_(QString(GONIO_TEST_OUTPUT_DIR) + "/" + name + "/") {
    QDir(path_).removeRecursively();
    QDir().mkpath(path_);
  }
  QString path(const QString& name = {}) const { return path_ + name; }

  void writeText(const QString& name, const QByteArray& text) const {
    QFile file(path(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) throw Error("cannot write a test file");
  }
  /// A model's table as a MERL file, of its first parameters; returns its path.
  QString writeTable(const QString& name, const char* model, const models::ParameterValues& parameters,
                     const HalfDifferenceGrid& grid = smallGrid) const {
    const models::Model& source = models::findModel(model);
    const auto brdf = source.instantiate(test::leadingParameters(source, parameters.values));
    test::writeTable(*bakeTable(*brdf, grid), path(name).toStdString());
    return path(name);
  }

 private:
  QString path_;
};

inline QByteArray bytesOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

inline std::shared_ptr<const TabulatedBrdf> readTable(const QString& path) {
  return materials::readMaterial(path.toStdString()).tabulated();
}

}  // namespace gonio::test

#define VERIFY_SUCCESS(result) QVERIFY2((result).code == 0, qPrintable((result).error))
