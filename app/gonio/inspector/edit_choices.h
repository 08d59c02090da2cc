// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "app/gonio/document/document.h"

class QCheckBox;
class QComboBox;

namespace gonio::app {

/// Choice of the composition of the active model edit with the measurement, and whether its highlights keep their
/// albedo; hidden if there is no such edit.
class CompositionChoice : public QWidget {
  Q_OBJECT

 public:
  explicit CompositionChoice(Document& document, QWidget* parent = nullptr);
  QComboBox& choice() { return *m_choice; }

 private:
  void refresh();

  Document& m_document;
  QComboBox* m_choice;
  QCheckBox* m_keepsAlbedo;
};

/// Choice of the incident direction of a measurement that is not reciprocal (RGL and UTIA files); hidden for all
/// others.
class IncidentDirectionChoice : public QWidget {
  Q_OBJECT

 public:
  explicit IncidentDirectionChoice(Document& document, QWidget* parent = nullptr);
  QComboBox& choice() { return *m_choice; }

 private:
  void refresh();

  Document& m_document;
  QComboBox* m_choice;
};

}  // namespace gonio::app
