// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <optional>

#include "app/gonio/document/document.h"
#include "app/gonio/matching/reference_image.h"
#include "core/matching/control_match.h"

namespace gonio::widgets {
class PreviewWidget;
}

namespace gonio::app {

class BackgroundTasks;
class ComparisonController;
class DocumentController;

/// The reference image of a window, and the match of the active edit's controls with it. A match is a proposal: the
/// preview shows it instead of the edited material until it is taken, in one undo step, or left, which changes nothing.
/// A change of the document leaves it. The image is not part of the document.
class MatchController : public QObject {
  Q_OBJECT

 public:
  MatchController(Document& document, DocumentController& controller, BackgroundTasks& tasks,
                  ComparisonController& comparison, widgets::PreviewWidget& preview);

  /// Reads an image in the background.
  void open(const QString& path);
  void remove();
  const std::optional<ReferenceImage>& image() const { return m_image; }
  void setDisc(const matching::Disc& disc);
  void setTones(ImageTones tones);
  ImageTones tones() const { return m_tones; }

  /// Whether match() can start: there are an image and a material, and none is running.
  bool canMatch() const;
  /// Fits the controls of the active edit in the background, after a fit of the default model if there is no edit.
  void match();
  void cancel();
  bool isMatching() const { return m_matching; }
  /// Progress of the running match, [0, 1].
  double progress() const;

  struct Proposal {
    matching::ControlMatch match;
    editing::EditList edits;  ///< of the document, with the controls
    std::size_t index;        ///< of the edit that changed
  };
  const std::optional<Proposal>& proposal() const { return m_proposal; }
  void take();
  void leave();

 Q_SIGNALS:
  /// The image, the state of the match, or the proposal changed.
  void changed();
  void progressed();
  /// A new proposal is shown.
  void proposed();
  void failed(const QString& title, const QString& text);

 private:
  void documentChanged();
  void start();
  void end();
  void show(const matching::ControlMatch& match, editing::EditList edits, std::size_t index);

  Document& m_document;
  DocumentController& m_controller;
  BackgroundTasks& m_tasks;
  ComparisonController& m_comparison;
  widgets::PreviewWidget& m_preview;
  std::optional<ReferenceImage> m_image;
  ImageTones m_tones = ImageTones::clamp;
  std::optional<Proposal> m_proposal;
  bool m_matching = false;
  bool m_waiting = false;  ///< for the fit of a model
};

}  // namespace gonio::app
