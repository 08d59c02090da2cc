// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

#include "app/gonio/acquisition/acquisition_controls.h"

class QFileDialog;

namespace gonio::app {

/// Passes the measured material selected in the controls to a session, as its reference: the open material with its
/// edits (only while the controls are visible), a chosen material, or none.
class MeasuredMaterialSource : public QObject {
  Q_OBJECT

 public:
  MeasuredMaterialSource(const Document& document, AcquisitionSession& session, AcquisitionControls& controls);

  /// Updates the session's reference from the document, if the document's material is the selected one.
  void takeOpenMaterial();
  /// Selects a material. @param id a file or a material of the library.
  void choose(const QString& id);
  /// Fixes the measured material to the one that is open now, before another one is opened.
  void fixOpenMaterial();

 private:
  void edited();
  void showReference();

  const Document& m_document;
  AcquisitionSession& m_session;
  AcquisitionControls& m_controls;
  std::shared_ptr<const Brdf> m_taken;  ///< base of the reference
  std::vector<editing::Edit> m_takenEdits;
};

/// Exchange of a session's plan and values as files and as clipboard text.
class AcquisitionFiles : public QObject {
  Q_OBJECT

 public:
  /// @param panel the parent of the dialogs.
  AcquisitionFiles(AcquisitionSession& session, AcquisitionControls& controls, MeasuredMaterialSource& source,
                   QWidget* panel);

  /// The plan as comma-separated text, with its settings in comments.
  QString planText() const;
  void savePlan(const QString& path);
  /// Reads a plan saved by the editor or goniotool and uses its directions instead of selecting new ones. The principal
  /// components are learned from the training set selected in the controls.
  void readPlan(const QString& path);
  /// Reads values from comma-separated text, one row per sample. Reports errors.
  void paste(const QString& text);
  void readValues(const QString& path);

  void askForPlan();
  void askForPlanFile();
  void askForValues();

  /// Shows a dialog for an existing file, or for a new CSV file, in the folder of acquisitions, which it remembers. The
  /// caller connects QFileDialog::fileSelected(). @param name proposed for the file, without suffix; empty: none.
  QFileDialog* openDialog(const QString& title, const QString& filter);
  QFileDialog* saveDialog(const QString& title, const QString& filter, const QString& name = {});

 Q_SIGNALS:
  void exported(const QString& path);
  void failed(const QString& title, const QString& text);

 private:
  std::vector<std::string> planComments() const;

  AcquisitionSession& m_session;
  AcquisitionControls& m_controls;
  MeasuredMaterialSource& m_source;
  QWidget* m_panel;
};

}  // namespace gonio::app
