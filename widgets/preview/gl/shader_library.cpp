// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/shader_library.h"

#include <QFile>
#include <QSet>

#include "core/support/error.h"
#include "widgets/preview/gl/model_uniforms.h"

namespace gonio::widgets {

namespace {

/// The tree: in the resources, or the folder of the sources.
QString root() { return qEnvironmentVariable("GONIO_SHADER_DIR", QStringLiteral(":")); }

QByteArray readShader(const QString& name) {
  if (const QString models = QStringLiteral("models/"); name.startsWith(models))
    return modelShader(models::findModel(name.mid(models.size()).replace('_', '-').toStdString()));
  QFile file(root() + (name.startsWith("core/") ? "/" : "/shaders/") + name);
  if (!file.open(QIODevice::ReadOnly))
    throw Error("shader " + file.fileName().toStdString() + ": " + file.errorString().toStdString());
  return file.readAll();
}

void appendExpanded(QByteArray& text, const QString& name, QSet<QString>& included) {
  if (included.contains(name)) return;
  included.insert(name);
  text += "// " + name.toUtf8() + '\n';
  for (const QByteArray& line : readShader(name).split('\n')) {
    const QByteArray trimmed = line.trimmed();
    if (trimmed == "#pragma once" || trimmed.startsWith("// SPDX-")) continue;
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
