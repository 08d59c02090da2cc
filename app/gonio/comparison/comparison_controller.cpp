// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/comparison/comparison_controller.h"

#include <algorithm>

#include "app/gonio/document/loaded_material.h"
#include "app/gonio/document/material_files.h"
#include "widgets/inputs/menu_text.h"
#include "widgets/parameters/parameter_text.h"
#include "widgets/preview/comparison_bar.h"
#include "widgets/preview/preview_overlay.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {

using widgets::ComparedSubject;
using widgets::CompareMode;

namespace {
const QString openReferenceKey = QStringLiteral("reference");
constexpr std::array allSides{ComparedSubject::measured, ComparedSubject::fit, ComparedSubject::edited,
                              ComparedSubject::reference};

HalfDifferenceGrid gridOf(const Brdf& brdf) {
  const auto* table = formOf<TabulatedBrdf>(brdf);
  return table ? table->grid() : HalfDifferenceGrid();
}
}  // namespace

ComparisonController::ComparisonController(Document& document, BackgroundTasks& tasks, widgets::PreviewWidget& preview,
                                           widgets::ComparisonBar& bar, QObject* parent)
    : QObject(parent), m_document(document), m_tasks(tasks), m_preview(preview), m_bar(bar) {
  for (const auto signal :
       {&Document::materialChanged, &Document::stateChanged, &Document::editChanged, &Document::selectionChanged})
    connect(&document, signal, this, &ComparisonController::refresh);
  for (const auto signal : {&Document::materialChanged, &Document::stateChanged, &Document::editChanged})
    connect(&document, signal, this, &ComparisonController::endPair);
  connect(&bar, &widgets::ComparisonBar::comparisonEdited, this, &ComparisonController::setComparison);
  connect(&bar, &widgets::ComparisonBar::sidesEdited, this, &ComparisonController::setSides);
  connect(&bar, &widgets::ComparisonBar::referenceRequested, this, &ComparisonController::referenceRequested);
  connect(&bar, &widgets::ComparisonBar::referenceDropped, this, &ComparisonController::openReference);
  connect(&bar, &widgets::ComparisonBar::flickerHeld, &preview, &widgets::PreviewWidget::setFlickering);
  connect(&preview, &widgets::PreviewWidget::splitMoved, this, [this](double fraction) {
    m_comparison.split = fraction;
    m_bar.setComparison(m_comparison);
  });
  connect(&preview, &widgets::PreviewWidget::frameRendered, this, [this] {
    if (m_preview.differenceRange() > 0) m_bar.setFoundRange(m_preview.differenceRange());
  });
  connect(preview.overlay()->banner(), &widgets::PreviewBanner::dismissed, this, &ComparisonController::dismissStandIn);
  refresh();
}

void ComparisonController::openReference(const QString& path) {
  m_tasks.run<LoadedMaterialPtr>(
      {tr("Opening %1 as the reference").arg(shortName(path)), openReferenceKey},
      [path](const TaskControl& control) { return loadEdited(path.toStdString(), control); },
      [this](const LoadedMaterialPtr& material) {
        m_reference = material;
        const ComparedSubject first = m_sides[0] == ComparedSubject::reference ? ComparedSubject::edited : m_sides[0];
        setSides(first, ComparedSubject::reference);
        if (m_comparison.mode == CompareMode::off) toggle();
      },
      [this, path](const QString& error) { Q_EMIT failed(tr("Cannot open %1").arg(path.section('/', -1)), error); });
}

void ComparisonController::toggle() {
  widgets::PreviewComparison comparison = m_comparison;
  comparison.mode = m_comparison.mode == CompareMode::off ? m_lastMode : CompareMode::off;
  setComparison(comparison);
}

void ComparisonController::setComparison(const widgets::PreviewComparison& comparison) {
  if (m_comparison.mode == CompareMode::off && comparison.mode != CompareMode::off && !m_sidesChosen && !m_pair)
    chooseUsualSides();
  if (comparison.mode == CompareMode::off) endPair();
  m_comparison = comparison;
  if (comparison.mode != CompareMode::off) m_lastMode = comparison.mode;
  m_bar.setComparison(comparison);
  refresh();
  m_preview.content().setComparison(comparison);
  Q_EMIT comparisonChanged();
}

bool ComparisonController::isEdited() const { return !editing::isIdentity(m_document.edits()); }

void ComparisonController::chooseUsualSides() {
  m_sides = {isEdited() || standIn() || code() ? ComparedSubject::edited : ComparedSubject::fit,
             ComparedSubject::measured};
}

void ComparisonController::setSides(ComparedSubject first, ComparedSubject second) {
  m_sidesChosen = true;
  m_pair.reset();
  m_sides = {first, second};
  refresh();
}

std::optional<StandIn> ComparisonController::standIn() const {
  for (std::size_t kind = 0; kind < m_standIns.size(); ++kind)
    if (m_standIns[kind].subject) return StandIn(kind);
  return std::nullopt;
}

QString ComparisonController::standInName() const {
  const auto kind = standIn();
  return kind ? m_standIns[std::size_t(*kind)].name : QString();
}

void ComparisonController::setStandIn(StandIn kind, std::optional<widgets::PreviewSubject> subject,
                                      const QString& name) {
  Replacement& replacement = m_standIns[std::size_t(kind)];
  if (!subject && !replacement.subject) return;
  const bool stoodIn = standIn().has_value();
  replacement = {std::move(subject), name};
  if (standIn().has_value() != stoodIn && !m_sidesChosen) chooseUsualSides();
  refresh();
}

void ComparisonController::setPair(const std::array<Named, 2>& pair) {
  m_pair = m_pair ? Pair{pair, m_pair->sidesBefore, m_pair->modeBefore} : Pair{pair, m_sides, m_comparison.mode};
  m_sides = {ComparedSubject::edited, ComparedSubject::reference};
  if (m_comparison.mode != CompareMode::off) return refresh();
  widgets::PreviewComparison comparison = m_comparison;
  comparison.mode = m_lastMode;
  setComparison(comparison);
}

void ComparisonController::endPair() {
  if (!m_pair) return;
  const Pair ended = *std::exchange(m_pair, std::nullopt);
  m_sides = ended.sidesBefore;
  if (ended.modeBefore != CompareMode::off) return refresh();
  widgets::PreviewComparison comparison = m_comparison;
  comparison.mode = CompareMode::off;
  setComparison(comparison);
}

const ComparisonController::Named* ComparisonController::pairSide(ComparedSubject side) const {
  if (!m_pair || (side != ComparedSubject::edited && side != ComparedSubject::reference)) return nullptr;
  return &m_pair->subjects[side == ComparedSubject::edited ? 0 : 1];
}

void ComparisonController::dismissStandIn() {
  if (m_pair) return endPair();
  if (const auto kind = standIn()) return Q_EMIT standInDismissed(*kind);
  if (code()) Q_EMIT codeDismissed();
}

void ComparisonController::showBanner() {
  if (m_pair)
    return m_preview.overlay()->setBanner(
        tr("Showing %1 against %2").arg(m_pair->subjects[0].name, m_pair->subjects[1].name),
        tr("Back to the Material"));
  const auto kind = standIn();
  if (!kind && code())
    return m_preview.overlay()->setBanner(tr("Showing a code of %1 with %2 coefficients")
                                              .arg(widgets::spacedName(m_document.name()))
                                              .arg(code()->coefficients),
                                          tr("Back to the Measurement"));
  if (!kind) return m_preview.overlay()->setBanner({}, {});
  const QString what = *kind == StandIn::blend ? tr("the blend %1").arg(standInName()) : standInName();
  if (!m_document.material())
    return m_preview.overlay()->setBanner(tr("Showing %1").arg(widgets::spacedName(what)), tr("Hide the Blend"));
  m_preview.overlay()->setBanner(
      tr("Showing %1 instead of %2").arg(widgets::spacedName(what), widgets::spacedName(m_document.name())),
      *kind == StandIn::match ? tr("Leave") : tr("Back to the Material"));
}

void ComparisonController::setCode(std::shared_ptr<const MaterialCode> code) {
  if (code == m_code) return;
  m_code = std::move(code);
  if (!m_sidesChosen) chooseUsualSides();
  refresh();
}

const MaterialCode* ComparisonController::code() const {
  return m_code && m_code->material == m_document.material() ? m_code.get() : nullptr;
}

void ComparisonController::setWavelength(std::optional<WavelengthSubjects> subjects) {
  m_wavelength = std::move(subjects);
  refresh();
}

const WavelengthSubjects* ComparisonController::wavelength() const {
  return m_wavelength && m_wavelength->material == m_document.material() ? &*m_wavelength : nullptr;
}

widgets::PreviewSubject ComparisonController::subject(ComparedSubject side) const {
  if (const Named* one = pairSide(side)) return one->subject;
  if (const auto kind = standIn(); side == ComparedSubject::edited && kind)
    return *m_standIns[std::size_t(*kind)].subject;
  const LoadedMaterialPtr& material = side == ComparedSubject::reference ? m_reference : m_document.material();
  if (!material) return {};
  if (const WavelengthSubjects* one = wavelength(); one && side == ComparedSubject::edited) return one->edited;
  if (const WavelengthSubjects* one = wavelength(); one && side == ComparedSubject::measured) return one->measured;
  if (side == ComparedSubject::edited && code())
    return {widgets::EditedMaterial{code()->table, m_document.edits(), code()->stored}, code()->density};
  if (side == ComparedSubject::edited)
    return {widgets::EditedMaterial{m_document.base(), m_document.edits()}, material->density};
  if (side == ComparedSubject::measured) return widgets::measuredSubject(m_document.base(), material->density);
  if (side != ComparedSubject::fit) return widgets::measuredSubject(material->base, material->density);
  const auto* edit = m_document.active<editing::DifferentialEdit>();
  if (!edit) return {};
  return {widgets::StandaloneModel{edit->model, edit->fitted, gridOf(*material->base)}, material->density};
}

QString ComparisonController::name(ComparedSubject side) const {
  const LoadedMaterialPtr& material = m_document.material();
  if (const Named* one = pairSide(side)) return one->name;
  if (const auto kind = standIn(); side == ComparedSubject::edited && kind)
    return *kind == StandIn::blend ? tr("Blend") : standInName();
  if (side == ComparedSubject::reference)
    return m_reference ? widgets::spacedName(QString::fromStdString(m_reference->material.name)) : QString();
  if (!material) return {};
  if (const WavelengthSubjects* one = wavelength();
      one && (side == ComparedSubject::measured || side == ComparedSubject::edited))
    return tr("%1, %2 nm")
        .arg(side == ComparedSubject::edited && isEdited() ? tr("Edited") : sourceKind(*material))
        .arg(one->nanometres, 0, 'f', 0);
  if (side == ComparedSubject::measured) return sourceKind(*material);
  if (side == ComparedSubject::edited && code()) return isEdited() ? tr("Encoded, edited") : tr("Encoded");
  if (side == ComparedSubject::edited)
    return isEdited() ? tr("Edited") : widgets::spacedName(QString::fromStdString(material->material.name));
  const auto* edit = m_document.active<editing::DifferentialEdit>();
  return edit ? tr("Fit: %1").arg(widgets::toQString(edit->model->spec().name)) : QString();
}

void ComparisonController::refresh() {
  const bool comparing = m_comparison.mode != CompareMode::off;
  const ComparedSubject first = comparing ? m_sides[0] : ComparedSubject::edited;
  const bool asMeasured = !comparing && !wavelength() && m_document.material() && !isEdited() && !standIn() && !code();
  m_preview.content().setSubject(subject(first), asMeasured ? sourceKind(*m_document.material()) : name(first));
  m_preview.content().setSecond(subject(m_sides[1]), name(m_sides[1]));
  std::array<QString, 4> names;
  for (const ComparedSubject side : allSides) names[std::size_t(side)] = name(side);
  m_bar.setSubjects(names);
  m_bar.setSides(m_sides[0], m_sides[1]);
  showBanner();
  Q_EMIT subjectsChanged();
}

}  // namespace gonio::app

#include "moc_comparison_controller.cpp"
