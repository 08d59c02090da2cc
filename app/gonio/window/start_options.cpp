// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/start_options.h"

#include <QApplication>
#include <QCommandLineParser>
#include <utility>

#include "app/gonio/document/material_files.h"

namespace gonio::app {
namespace {

/// Options with a value; hidden from help.
constexpr std::pair<const char*, const char*> valueOptions[]{{"screenshot", "OUT.png"},
                                                             {"size", "WxH"},
                                                             {"wait", "SECONDS"},
                                                             {"theme", "NAME"},
                                                             {"thumbnails", "FOLDER"},
                                                             {"plot", "KIND"},
                                                             {"figure", "DESCRIPTION.json"},
                                                             {"compare", "MODE"},
                                                             {"study", "LABEL"},
                                                             {"widen", "FACTOR"},
                                                             {"take-f1", "FILE"},
                                                             {"interpolate", "A,B,..."},
                                                             {"encoded", "COUNT"},
                                                             {"acquire", "COUNT"},
                                                             {"acquisition-page", "0-3"},
                                                             {"scene", "NAME"},
                                                             {"slots", "B,C,..."}};
constexpr const char* switches[]{"models", "factors", "opening-times", "event-times"};

void addHidden(QCommandLineParser& parser, QCommandLineOption option) {
  option.setFlags(QCommandLineOption::HiddenFromHelp);
  parser.addOption(option);
}

QStringList listOf(const QString& value) { return value.split(',', Qt::SkipEmptyParts); }

QSize sizeOf(const QString& value) {
  const QStringList numbers = value.split('x');
  return numbers.size() == 2 ? QSize(numbers[0].toInt(), numbers[1].toInt()) : QSize();
}

PreparedView viewOf(const QCommandLineParser& parser) {
  return {.plot = parser.value("plot"),
          .compare = parser.value("compare"),
          .models = parser.isSet("models"),
          .factors = parser.isSet("factors"),
          .study = parser.value("study"),
          .widen = parser.value("widen").toDouble(),
          .withF1Of = parser.value("take-f1"),
          .blended = listOf(parser.value("interpolate")),
          .encoded = parser.value("encoded").toULongLong(),
          .scene = parser.value("scene"),
          .otherSlots = listOf(parser.value("slots")),
          .acquired = parser.value("acquire").toInt(),
          .acquisitionPage = parser.value("acquisition-page").toInt()};
}

}  // namespace

StartOptions readOptions(const QApplication& application) {
  QCommandLineParser parser;
  parser.setApplicationDescription(QObject::tr("An editor for measured materials (BRDFs)."));
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument(
      "file",
      QObject::tr("Materials (%1) or documents (*%2) to open.").arg(materialFilePatterns().join(' '), documentSuffix()),
      "[FILE ...]");
  for (const auto& [name, value] : valueOptions) addHidden(parser, QCommandLineOption(name, {}, value));
  for (const char* name : switches) addHidden(parser, QCommandLineOption(name));
  parser.process(application);
  return {.files = parser.positionalArguments(),
          .screenshot = parser.value("screenshot"),
          .size = sizeOf(parser.value("size")),
          .waitSeconds = parser.isSet("wait") ? parser.value("wait").toDouble() : 60,
          .theme = parser.value("theme"),
          .thumbnails = parser.value("thumbnails"),
          .figure = parser.value("figure"),
          .openingTimes = parser.isSet("opening-times"),
          .eventTimes = parser.isSet("event-times"),
          .view = viewOf(parser)};
}

}  // namespace gonio::app
