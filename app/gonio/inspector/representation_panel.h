// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QTimer>
#include <QWidget>
#include <optional>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/document.h"
#include "app/gonio/document/file_exports.h"
#include "app/gonio/document/material_code.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QSlider;

namespace gonio::widgets {
class FactList;
}

namespace gonio::app {

/// The content of the inspector's Representation section: the document's material as a sparse code with a selectable
/// number of coefficients, with its measured error, bytes and time. Encodes in the background while the panel is
/// visible or the preview shows the code. It does not change the document.
class RepresentationPanel : public QWidget {
  Q_OBJECT

 public:
  using CodePtr = std::shared_ptr<const MaterialCode>;

  RepresentationPanel(Document& document, BackgroundTasks& tasks, QWidget* parent = nullptr);

  /// The selected number of coefficients per channel. setCoefficients() selects the nearest step.
  std::size_t coefficients() const;
  void setCoefficients(std::size_t coefficients);
  /// The code of the document's material; null until it is known.
  const CodePtr& code() const { return m_code; }
  /// The code that the preview shows instead of the measurement; null: the measurement.
  CodePtr shown() const;
  QCheckBox& showEncoded() const { return *m_show; }
  /// Whether the requested code is known, or none is requested.
  bool isSettled() const;

 Q_SIGNALS:
  void shownChanged();
  void saveRequested(const gonio::app::FileSave& save);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  bool isWanted() const;
  void request();
  void adopt(const MaterialCode& code);
  void stop(const QString& why);
  void forget();
  void refresh();
  void save();

  Document& m_document;
  BackgroundTasks& m_tasks;
  QSlider* m_slider;
  QLabel *m_count, *m_state;
  QPushButton *m_encode, *m_save;
  QCheckBox* m_show;
  widgets::FactList* m_facts;
  QTimer m_delay;
  CodePtr m_code;
  std::optional<std::size_t> m_requested;  ///< coefficients of the running encoding
  QString m_refusal;                       ///< why there is no code; empty if it only has not been made yet
};

}  // namespace gonio::app
