// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

#include "app/gonio/acquisition/acquisition_controls.h"

namespace gonio::app {

/// Gives a session the material that its controls ask for: the open material with its edits while the controls are in
/// sight, one that was chosen, or none.
class AcquisitionSubject : public QObject {
  Q_OBJECT

 public:
  AcquisitionSubject(const Document& document, AcquisitionSession& session, AcquisitionControls& controls);

  /// The document's material, where that is what is measured.
  void takeOpenMaterial();
  /// A file or a material of the library.
  void choose(const QString& id);
  /// Another material is to be opened: what is measured now goes on being measured.
  void keepOpenMaterial();

 private:
  void edited();
  void showReference();

  const Document& m_document;
  AcquisitionSession& m_session;
  AcquisitionControls& m_controls;
  std::shared_ptr<const Brdf> m_taken;  ///< the base of the reference
  std::vector<editing::Edit> m_takenEdits;
};

}  // namespace gonio::app
