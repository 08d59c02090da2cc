// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/matching/reference_panel.h"

#include <QComboBox>
#include <QKeyEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStandardItemModel>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>

#include "app/gonio/comparison/comparison_numbers.h"
#include "app/gonio/matching/match_controller.h"
#include "app/gonio/matching/reference_view.h"
#include "core/matching/ball_pictures.h"
#include "widgets/parameters/parameter_text.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {

namespace {

/// Radius of the ball in the preview, in pixels of the widget.
double shownRadius(const widgets::PreviewWidget& preview) {
  const rendering::Scene& scene = preview.content().scene();
  const rendering::Sphere ball = matching::ballOf(scene);
  const rendering::CameraFrame frame = rendering::cameraFrame(scene.camera);
  const QSize size = preview.content().pictureSize();
  const double half = 0.5 * std::min(size.width(), size.height()) / preview.devicePixelRatioF();
  const double distance = glm::length(frame.eye - ball.centre);
  if (frame.orthographic || distance <= ball.radius) return half * ball.radius / frame.halfExtent;
  return half * ball.radius / std::sqrt(distance * distance - ball.radius * ball.radius) / frame.halfExtent;
}

}  // namespace

ReferencePanel::ReferencePanel(MatchController& match, const Document& document, widgets::PreviewWidget& preview,
                               QWidget* parent)
    : QWidget(parent),
      m_match(match),
      m_document(document),
      m_preview(preview),
      m_title(new QLabel),
      m_text(new QLabel),
      m_close(new QToolButton),
      m_view(new ReferenceView),
      m_tones(new QComboBox),
      m_start(new QPushButton(tr("Match"))),
      m_take(new QPushButton(tr("Take"))),
      m_leave(new QPushButton(tr("Leave"))),
      m_progress(new QProgressBar) {
  build();
  connect(m_close, &QToolButton::clicked, &match, &MatchController::remove);
  connect(m_start, &QPushButton::clicked, &match, [&match] { match.isMatching() ? match.cancel() : match.match(); });
  connect(m_take, &QPushButton::clicked, &match, &MatchController::take);
  connect(m_leave, &QPushButton::clicked, &match, &MatchController::leave);
  connect(m_tones, &QComboBox::activated, &match, [&match](int index) { match.setTones(ImageTones(index)); });
  connect(m_view, &ReferenceView::discDragged, &match, &MatchController::setDisc);
  connect(&match, &MatchController::changed, this, &ReferencePanel::refresh);
  connect(&match, &MatchController::proposed, m_take, [this] { m_take->setFocus(); });
  connect(&match, &MatchController::progressed, this,
          [this] { m_progress->setValue(int(std::lround(100 * m_match.progress()))); });
  connect(&preview.content(), &widgets::PreviewContent::sceneChanged, this, &ReferencePanel::showScale);
  connect(&preview.content(), &widgets::PreviewContent::comparisonChanged, this, &ReferencePanel::showScale);
  preview.installEventFilter(this);
  refresh();
}

void ReferencePanel::build() {
  m_title->setTextFormat(Qt::PlainText);
  m_title->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  m_close->setText(QStringLiteral("\u2715"));
  m_close->setAutoRaise(true);
  m_close->setToolTip(tr("Removes the reference image"));
  m_close->setAccessibleName(tr("Remove reference image"));
  m_tones->addItems({tr("Render, tone map Clamp"), tr("Render, tone map Filmic"), tr("Photograph")});
  m_tones->setAccessibleName(tr("Kind of image"));
  m_tones->setToolTip(
      tr("How the image became bright: a render has the tone map named here and the exposure of the view; the exposure "
         "of a photograph is unknown and is fitted too"));
  m_start->setToolTip(
      tr("Fits roughness, specular strength, tint, saturation and coat of the selected edit, so that "
         "the material looks like the sphere in the image under the current light and camera"));
  m_take->setToolTip(tr("Uses the values, in one undo step (Enter)"));
  m_leave->setToolTip(tr("Returns to the edit as it was (Escape)"));
  m_take->setAutoDefault(true);
  m_text->setTextFormat(Qt::PlainText);
  m_text->setWordWrap(true);
  m_progress->setRange(0, 100);
  m_progress->setTextVisible(false);
  m_progress->setAccessibleName(tr("Progress of the match"));

  auto* top = new QHBoxLayout;
  top->addWidget(m_title, 1);
  top->addWidget(m_close);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(m_tones);
  buttons->addStretch(1);
  for (QPushButton* button : {m_start, m_take, m_leave}) buttons->addWidget(button);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 3, 6, 6);
  layout->addLayout(top);
  layout->addWidget(m_view, 1);
  layout->addWidget(m_text);
  layout->addWidget(m_progress);
  layout->addLayout(buttons);
}

QString ReferencePanel::proposalText() const {
  const matching::ControlMatch& match = m_match.proposal()->match;
  const editing::EditList& edits = m_match.proposal()->edits;
  const auto& edit = std::get<editing::DifferentialEdit>(edits[m_match.proposal()->index].content);
  QStringList values;
  for (const editing::ArtistControl control : matching::matchedControls(edit)) {
    const models::ParameterSpec& spec = editing::artistControls().parameters[std::size_t(control)];
    values << QStringLiteral("%1 %2").arg(widgets::toQString(spec.label),
                                          widgets::displayValue(spec, match.controls.values[std::size_t(control)]));
  }
  if (m_match.tones() == ImageTones::photograph)
    values << tr("exposure of the image %1 stops").arg(match.exposure, 0, 'f', 1);
  return tr("Match: %1 (%2 dB). %3")
      .arg(matchWord(match.signalToNoiseRatio))
      .arg(match.signalToNoiseRatio, 0, 'f', 1)
      .arg(values.join(QStringLiteral(", ")));
}

QString ReferencePanel::message() const {
  if (!m_document.material()) return tr("Open a material to match it with the image.");
  if (m_match.isMatching()) return tr("Fitting the controls...");
  if (m_match.proposal()) return proposalText();
  if (m_match.image() && !m_match.image()->found)
    return tr("No sphere was found. Drag the circle onto the outline of the sphere.");
  if (!m_document.active<editing::DifferentialEdit>()) return tr("Match fits a model first, then its controls.");
  return {};
}

void ReferencePanel::refresh() {
  setVisible(m_match.image().has_value());
  if (!m_match.image()) return;
  const ReferenceImage& image = *m_match.image();
  m_title->setText(image.name());
  m_title->setToolTip(image.path);
  m_view->setImage(image.shown, image.disc);
  const QString text = message();
  m_text->setText(text);
  m_text->setVisible(!text.isEmpty());
  m_progress->setVisible(m_match.isMatching());
  if (!m_match.isMatching()) m_progress->setValue(0);
  m_tones->setCurrentIndex(int(m_match.tones()));
  // The values of HDR and EXR files are radiance.
  qobject_cast<QStandardItemModel*>(m_tones->model())->item(int(ImageTones::filmic))->setEnabled(!image.isRadiance);
  m_tones->setItemText(int(ImageTones::clamp), image.isRadiance ? tr("Render") : tr("Render, tone map Clamp"));
  const bool hasProposal = m_match.proposal().has_value();
  m_start->setText(m_match.isMatching() ? tr("Cancel") : tr("Match"));
  m_start->setVisible(!hasProposal);
  m_start->setEnabled(m_match.isMatching() || m_match.canMatch());
  m_take->setVisible(hasProposal);
  m_leave->setVisible(hasProposal);
  m_tones->setEnabled(!hasProposal && !m_match.isMatching());
  showScale();
}

void ReferencePanel::showScale() { m_view->setShownRadius(shownRadius(m_preview)); }

bool ReferencePanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize)
    QMetaObject::invokeMethod(this, &ReferencePanel::showScale, Qt::QueuedConnection);
  return QWidget::eventFilter(watched, event);
}

void ReferencePanel::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape || !m_match.proposal()) return QWidget::keyPressEvent(event);
  m_match.leave();
}

}  // namespace gonio::app

#include "moc_reference_panel.cpp"
