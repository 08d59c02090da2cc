// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QFile>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeView>

#include "app/gonio/document/edit_steps.h"
#include "app/gonio/figures/figure_dialog.h"
#include "app/gonio/figures/figure_view.h"
#include "core/io/atomic_file.h"
#include "tests/app/gonio/document_edits.h"
#include "tests/app/gonio/glossy_material.h"
#include "tests/support/table_file.h"
#include "widgets/figures/entry_list.h"
#include "widgets/library/library_model.h"

namespace gonio::app::test_support {

/// Two materials as small files, and what the dialog of figures works with.
struct FigureEditor {
  QTemporaryDir folder;
  QSettings settings{folder.filePath("settings.ini"), QSettings::IniFormat};
  BackgroundTasks tasks;
  Document document;
  FileExports exports{document, tasks};
  widgets::LibraryModel library;
  QStringList selected;
  QSignalSpy exported{&exports, &FileExports::exported}, failed{&exports, &FileExports::failed};

  FigureEditor() {
    for (const auto& [name, roughness] : {std::pair{"chrome", 0.2}, {"rubber", 0.6}})
      test::writeTable(*formOf<TabulatedBrdf>(*glossyMaterial(roughness, {30, 30, 36})->base),
                       path(QString(name) + ".binary").toStdString());
  }

  QString path(const QString& name) const { return folder.filePath(name); }
  void write(const QString& name, const std::string& text) const {
    io::writeFileAtomically(path(name).toStdString(), text);
  }
  QByteArray bytes(const QString& name) const {
    QFile file(path(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  void open(const QString& name) { document.setMaterial(loadMaterial(path(name + ".binary").toStdString())); }
  void useFit(const char* model) {
    fitting::FitResult fit;
    fit.model = &models::findModel(model);
    fit.parameters = models::defaultParameters(fit.model->spec());
    document.adoptFit(fit);
  }
  void editRoughness() {
    useFit("ggx");
    editing::EditList edits = document.edits();
    auto& edit = std::get<editing::DifferentialEdit>(edits[0].content);
    edit.edited.values[*edit.model->spec().find("roughness")] = Rgb(0.7);
    document.replaceEdits(edits, "Roughness");
  }

  std::unique_ptr<FigureDialog> dialog() {
    auto made = std::make_unique<FigureDialog>(
        FigureDialog::Parts{document, exports, tasks, settings, library, [this] { return selected; }}, nullptr);
    made->show();
    return made;
  }
  static bool wait(const std::function<bool()>& done) { return QTest::qWaitFor(done, patienceMilliseconds); }
  bool settled(const FigureDialog& dialog) const {
    return wait([&] { return dialog.view().isSettled() && tasks.isIdle(); });
  }
  /// Both materials in two representations that are made in a moment.
  figures::FigureDescription smallFigure() const {
    figures::FigureDescription figure;
    figure.materials = {{path("chrome.binary").toStdString()}, {path("rubber.binary").toStdString(), "soft"}};
    figure.representations = {{study::representationById("ggx")}, {study::representationById("factors-3d", 1), "PDV"}};
    figure.pictures.size = 16;
    figure.pictures.samples = 4;
    figure.numbers = {"rendered-snr", "bytes"};
    return figure;
  }
};

/// All members, with values that no field shows in full.
inline figures::FigureDescription detailedFigure() {
  figures::FigureDescription figure;
  figure.title = "50 % & more";
  figure.width = figures::FigureWidth::oneColumn;
  figure.font = "No such font";
  figure.fontSize = 6.54321;
  figure.materials = {{"library:sgd/chrome", "mirror"}, {"/elsewhere/b.bsdf", ""}};
  figure.representations = {{study::representationById("code", 77), ""},
                            {study::representationById("ward"), "Ward 1992"}};
  figure.pictures = {.scene = "row",
                     .environment = "/elsewhere/sky.hdr",
                     .size = 123,
                     .samples = 45,
                     .exposure = 1.0 / 3,
                     .toneMap = rendering::ToneMap::filmic};
  figure.numbers = {"bytes", "flip", "rendered-snr"};
  figure.inset = figures::FigureInset{1.0 / 7, 1.0 / 9, 1.0 / 3};
  figure.errorMaps = false;
  figure.errorMaximum = 0.123456789e-6;
  return figure;
}

/// "Measure", or "Stop" while it measures.
inline QPushButton& measureButton(const FigureDialog& dialog) { return *dialog.view().findChild<QPushButton*>(); }

inline QPushButton* buttonOf(const QWidget& part, const QString& text) {
  for (QPushButton* button : part.findChildren<QPushButton*>())
    if (button->text().remove('&').startsWith(text)) return button;
  return nullptr;
}

/// An entry of an Add menu, also of the menus in it, as it is when it opens.
inline QAction* entryOf(QMenu& menu, const QString& text) {
  Q_EMIT menu.aboutToShow();
  const std::function<QAction*(const QMenu&)> find = [&](const QMenu& in) -> QAction* {
    for (QAction* action : in.actions()) {
      if (action->menu()) {
        if (QAction* found = find(*action->menu())) return found;
      } else if (action->text().remove('&').startsWith(text)) {
        return action;
      }
    }
    return nullptr;
  };
  return find(menu);
}

inline QStringList labelsOf(const widgets::EntryList& list) {
  QStringList labels;
  const QAbstractItemModel& model = *list.view().model();
  for (int row = 0; row < model.rowCount(); ++row)
    labels << model.index(row, model.columnCount() - 1).data().toString();
  return labels;
}

}  // namespace gonio::app::test_support
