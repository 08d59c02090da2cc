// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/inputs/dialogs.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

namespace gonio::widgets {

namespace {
QString keyOf(const QString& purpose) { return QStringLiteral("folders/") + purpose; }
}  // namespace

QString dialogFolder(const QString& purpose) {
  const QString folder = QSettings().value(keyOf(purpose)).toString();
  return !folder.isEmpty() && QDir(folder).exists() ? folder : QDir::homePath();
}

QString inDialogFolder(const QString& purpose, const QString& fileName) {
  return QDir(dialogFolder(purpose)).filePath(fileName);
}

void rememberDialogFolder(const QString& purpose, const QString& chosenFile) {
  if (!chosenFile.isEmpty()) QSettings().setValue(keyOf(purpose), QFileInfo(chosenFile).absolutePath());
}

}  // namespace gonio::widgets
