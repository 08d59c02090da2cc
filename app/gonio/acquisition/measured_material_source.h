// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

#include "app/gonio/acquisition/acquisition_controls.h"

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

}  // namespace gonio::app
