// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/interpolation/interpolation_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QToolButton>

#include "widgets/inputs/number_field.h"
#include "widgets/inputs/parameter_slider.h"
#include "widgets/interpolation/blend_pad.h"
#include "widgets/interpolation/blend_strip.h"
#include "widgets/interpolation/material_well.h"

namespace gonio::app {

namespace {
const QString keepKey = QStringLiteral("keep-blend");
using Space = editing::InterpolationSpace;
}  // namespace

InterpolationPanel::InterpolationPanel(Document& document, BackgroundTasks& tasks, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_tasks(tasks),
      m_ends(document, tasks),
      m_spaces(tasks),
      m_place(widgets::middlePlace(widgets::fewestBlended)),
      m_swap(new QToolButton),
      m_add(new QToolButton),
      m_places(new QStackedWidget),
      m_slider(new widgets::ParameterSlider),
      m_number(new widgets::NumberField),
      m_pad(new widgets::BlendPad),
      m_spaceBox(new QComboBox),
      m_show(new QCheckBox(tr("Show in the &preview"))),
      m_explanation(new QLabel),
      m_keep(new QPushButton(tr("&Keep as Material"))),
      m_draw(new QPushButton(tr("&Draw the Spaces"))),
      m_strip(new widgets::BlendStrip) {
  buildChoice();
  connectParts();
  setSpace(m_space);
  endsChanged();
}

std::vector<double> InterpolationPanel::weights() const { return widgets::weightsAt(m_ends.count(), m_place); }

bool InterpolationPanel::isShownInPreview() const { return m_show->isChecked(); }

void InterpolationPanel::setShownInPreview(bool shown) { m_show->setChecked(shown); }

std::optional<widgets::PreviewSubject> InterpolationPanel::subject() const {
  const widgets::PreparedBlendPtr blend = m_spaces.prepared(m_space);
  if (!isVisible() || !isShownInPreview() || !blend) return {};
  return widgets::blendSubject(*blend, m_spaces.ordered(weights()));
}

QString InterpolationPanel::description() const {
  QStringList shares;
  const std::vector<double> all = weights();
  for (int i = 0; i < m_ends.count(); ++i)
    if (const BlendEnd* end = m_ends.at(i); end && all[std::size_t(i)] > 0)
      shares << tr("%1 %2").arg(widgets::weightText(all[std::size_t(i)]), end->name);
  return tr("%1 (%2)").arg(shares.join(QStringLiteral(", ")), widgets::spaceName(m_space));
}

void InterpolationPanel::touched() { setShownInPreview(true); }

void InterpolationPanel::setSpace(Space space) {
  m_space = space;
  const int index = m_spaceBox->findData(int(space));
  m_spaceBox->setCurrentIndex(index);
  m_spaceBox->setToolTip(widgets::spaceExplanation(space));
  m_explanation->setText(widgets::spaceExplanation(space));
  m_strip->setCurrentRow(index);
  if (isVisible()) m_spaces.want(space);
  showPlace();
  Q_EMIT subjectChanged();
}

void InterpolationPanel::moveTo(const QPointF& place) {
  m_place = widgets::nearestPlace(m_ends.count(), place);
  touched();
  showPlace();
  Q_EMIT subjectChanged();
}

void InterpolationPanel::take(const QString& id) {
  touched();
  for (int i = 0; i < m_ends.count(); ++i)
    if (!m_ends.at(i) && !m_ends.isReading(i)) return m_ends.read(i, id);
  m_ends.read(m_ends.count() - 1, id);
}

void InterpolationPanel::begin() {
  if (m_document.material() && !m_ends.at(0) && !m_ends.isReading(0)) m_ends.takeCurrent(0);
  touched();
  m_wells[0]->setFocus(Qt::OtherFocusReason);
}

void InterpolationPanel::endsChanged() {
  m_place = widgets::nearestPlace(m_ends.count(), m_place);
  m_spaces.setEnds(m_ends.isComplete() ? m_ends.ends() : std::vector<editing::InterpolationEnd>());
  m_places->setCurrentIndex(m_ends.count() > widgets::fewestBlended ? 1 : 0);
  showWells();
  showStrip();
  if (isVisible()) m_spaces.want(m_space);
  Q_EMIT subjectChanged();
}

void InterpolationPanel::materialChanged() {
  // A blend that is still being kept was to take the place of the material that was open.
  m_tasks.drop(keepKey);
  showWells();
}

void InterpolationPanel::request() { m_spaces.want(m_space); }

void InterpolationPanel::showWells() {
  const std::vector<double> all = weights();
  std::vector<widgets::BlendCorner> corners;
  for (int i = 0; i < widgets::mostBlended; ++i) {
    widgets::MaterialWell& one = well(i);
    one.setVisible(i < m_ends.count());
    one.setCurrentAvailable(m_document.material() != nullptr);
    if (i >= m_ends.count()) continue;
    widgets::WellContent content;
    if (const BlendEnd* end = m_ends.at(i)) content = {end->name, end->description, end->picture, {}};
    corners.push_back({content.name, content.picture});
    content.removable = m_ends.count() > widgets::fewestBlended;
    content.note = m_ends.isReading(i)      ? tr("Opening...")
                   : content.name.isEmpty() ? QString()
                                            : widgets::weightText(all[std::size_t(i)]);
    if (const QString failure = m_ends.failure(i); !failure.isEmpty()) {
      content.note = tr("Could not be opened");
      content.toolTip = failure;
      content.failed = true;
    }
    one.setContent(content);
  }
  m_pad->setCorners(std::move(corners));
  m_add->setEnabled(m_ends.count() < widgets::mostBlended);
  showPlace();
}

void InterpolationPanel::showPlace() {
  const std::vector<double> all = weights();
  for (int i = 0; i < m_ends.count(); ++i)
    if (m_ends.at(i) && !m_ends.isReading(i) && m_ends.failure(i).isEmpty())
      well(i).setNote(widgets::weightText(all[std::size_t(i)]));
  m_slider->setNumber(m_place.x());
  m_number->setValue(m_place.x());
  m_pad->setPlace(m_place);
  // Only a place on the strip's way has a mark there.
  const double t = m_ends.count() == 3 ? 2 * m_place.x() : m_place.x();
  m_strip->setMark(widgets::wayPlace(m_ends.count(), t) == m_place ? t : -1);
  m_keep->setEnabled(m_spaces.prepared(m_space) != nullptr);
}

void InterpolationPanel::showStrip() {
  std::vector<widgets::BlendStrip::Row> rows;
  if (m_spaces.hasEnds()) rows.resize(m_spaces.spaces().size());
  m_strip->setRows(std::move(rows));
  for (const Space space : m_spaces.spaces()) showRow(space);
}

void InterpolationPanel::showRow(Space space) {
  const auto found = std::find(m_spaces.spaces().begin(), m_spaces.spaces().end(), space);
  const auto row = std::size_t(found - m_spaces.spaces().begin());
  bool cancelled = false;
  for (const Space one : m_spaces.spaces()) cancelled |= m_spaces.state(one) == BlendSpaces::State::cancelled;
  m_draw->setVisible(cancelled);
  if (row < m_strip->rows().size()) {
    widgets::BlendStrip::Row content{widgets::spaceName(space), widgets::spaceExplanation(space),
                                     m_spaces.pictures(space)};
    content.pictures.resize(BlendSpaces::pictureCount);
    switch (m_spaces.state(space)) {
      case BlendSpaces::State::failed:
        content.note = m_spaces.failure(space);
        content.failed = true;
        content.pictures.clear();
        break;
      case BlendSpaces::State::cancelled:
        content.note = tr("Cancelled");
        content.pictures.clear();
        break;
      case BlendSpaces::State::running:
        content.note = m_spaces.prepared(space) ? tr("Drawing...") : tr("Preparing...");
        break;
      default:
        break;
    }
    m_strip->setRow(int(row), std::move(content));
  }
  m_keep->setEnabled(m_spaces.prepared(m_space) != nullptr);
}

void InterpolationPanel::keep() {
  const widgets::PreparedBlendPtr blend = m_spaces.prepared(m_space);
  if (!blend) return Q_EMIT failed(tr("There is no blend to keep"), tr("Put a material in every place first."));
  auto source = std::make_shared<editing::BlendSource>();
  source->space = m_space;
  source->model = blend->model;
  // As they were prepared: a document makes the blend again in the order that it names.
  source->weights = m_spaces.ordered(weights());
  source->materials.resize(std::size_t(m_ends.count()));
  for (int i = 0; i < m_ends.count(); ++i) source->materials[m_spaces.order()[std::size_t(i)]] = m_ends.at(i)->source;
  const QString text = tr("Keep %1").arg(description());
  m_tasks.run<LoadedMaterialPtr>(
      {text, keepKey},
      [blend, source](const TaskControl& control) {
        constexpr double tableShare = 0.6;
        auto table = blend->interpolation->table(source->weights, control.between(0, tableShare));
        return measuredMaterial(editing::blendedMaterial(*source, std::move(table)), source,
                                control.between(tableShare, 1));
      },
      [this, text](const LoadedMaterialPtr& material) { m_document.replaceMaterial(material, text); },
      [this](const QString& error) { Q_EMIT failed(tr("Cannot keep the blend"), error); });
}

bool InterpolationPanel::isSettled() const {
  return !isVisible() || (!m_ends.isReading() && m_spaces.isSettled() && !m_tasks.isRunning(keepKey));
}

void InterpolationPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  m_spaces.want(m_space);
  Q_EMIT subjectChanged();
}

void InterpolationPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  m_spaces.pause();
  Q_EMIT subjectChanged();
}

}  // namespace gonio::app

#include "moc_interpolation_panel.cpp"
