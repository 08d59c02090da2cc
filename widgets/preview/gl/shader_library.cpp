// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/shader_library.h"

#include <QFile>
#include <QSet>

#include "core/support/error.h"

namespace gonio::widgets {

namespace {

QByteArray readShader(const QString& name) {
  const QString folder = qEnvironmentVariable("GONIO_SHADER_DIR", QStringLiteral(":/shaders"));
  QFile file(folder + '/' + name);
  if (!file.open(QIODevice::ReadOnly))
    throw Error("shader " + file.fileName().toStdString() + ": " + file.errorString().toStdString());
  return file.readAll();
}

void appendExpanded(QByteArray& text, const QString& name, QSet<QString>& included) {
  if (included.contains(name)) return;
  included.insert(name);
  for (const QByteArray& line : readShader(name).split('\n')) {
    const QByteArray trimmed = line.trimmed();
    if (trimmed.startsWith("#include"))
      appendExpanded(text, QString::fromUtf8(trimmed.mid(8).trimmed().replace('"', "")), included);
    else
      text += line + '\n';
  }
}

}  // namespace

QByteArray shaderText(const QString& name) {
  QByteArray text;
  QSet<QString> included;
  appendExpanded(text, name, included);
  return text;
}

QByteArray assembleShader(const QString& name, const QStringList& definitions, const QStringList& preamble) {
  QByteArray text = "#version 410 core\n";
  for (const QString& definition : definitions) text += "#define " + definition.toUtf8() + '\n';
  QSet<QString> included;
  for (const QString& file : preamble) appendExpanded(text, file, included);
  appendExpanded(text, name, included);
  return text;
}

}  // namespace gonio::widgets
