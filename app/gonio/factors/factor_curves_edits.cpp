// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// What the user's hand does to the factor curves: each an undo step of the document.
#include "app/gonio/document/edit_steps.h"
#include "app/gonio/factors/factor_curves_panel.h"
#include "core/editing/edit_list.h"
#include "core/factorization/pdv_operations.h"

namespace gonio::app {

namespace {

using editing::FactorEdit;
using factorization::PdvFactors;

FactorEdit::Curves shared(PdvFactors factors) { return std::make_shared<const PdvFactors>(std::move(factors)); }

}  // namespace

void FactorCurvesPanel::change(const PdvFactors& edited, const QString& text) {
  FactorEdit edit = current();
  const PdvFactors& original = *edit.original;
  // Curves that came back are those of the measurement, with its bound of y.
  const bool same = edited.channels == original.channels && edited.deviationNodes == original.deviationNodes;
  edit.edited = same ? edit.original : shared(edited);
  apply(edit, text);
}

void FactorCurvesPanel::apply(const FactorEdit& content, const QString& text) {
  // From the begin of the interaction: a drag that comes back leaves the list as it was.
  const EditState& base = m_document.stepBase();
  const int active = activeIndex<FactorEdit>(base);
  editing::Edit edit = active < 0 ? editing::Edit{} : base.edits[std::size_t(active)];
  edit.content = content;
  const bool untouched = content.isIdentity() && edit.enabled && edit.strength == 1 && edit.name.empty();
  if (active < 0) {
    // Next to the measurement, whose curves they are.
    if (untouched) return m_document.replaceEdits(base.edits, text, base.selected);
    return m_document.replaceEdits(editing::inserted(base.edits, 0, edit), text, 0);
  }
  // In the midst of a drag the edit stays, so that the hand goes on with the same one.
  if (untouched && !m_document.isInteracting())
    return m_document.replaceEdits(editing::removed(base.edits, std::size_t(active)), text);
  m_document.replaceEdits(editing::withEdit(base.edits, std::size_t(active), [&](editing::Edit& one) { one = edit; }),
                          text);
}

void FactorCurvesPanel::addEdit() {
  const FactorEdit edit = current();
  if (edit.original)
    app::addEdit(m_document, {FactorEdit{edit.original, edit.original, edit.preserveDetail}});
  else
    m_addWhenKnown = true;
}

void FactorCurvesPanel::curvesEdited(FactorAxis axis, const widgets::ChannelCurves& curves) {
  const FactorEdit edit = current();
  if (!edit.edited) return;
  PdvFactors changed = *edit.edited;
  for (std::size_t c = 0; c < 3; ++c) curveOf(changed.channels[c][0], axis) = curves[c];
  change(factorization::withRoomForEdits(changed), tr("Change F%1").arg(int(axis) + 1));
}

void FactorCurvesPanel::operate(FactorAxis axis, FactorOperation operation) {
  const FactorEdit edit = current();
  if (!edit.edited) return;
  change(operated(*edit.edited, *edit.original, axis, operation, channel()), operationText(operation, axis));
}

void FactorCurvesPanel::widen(double factor) {
  const FactorEdit edit = current();
  if (edit.edited) change(factorization::widenF2(*edit.edited, factor), tr("Widen F2 by %1").arg(factor));
}

void FactorCurvesPanel::chooseTerms(int terms) {
  if (!m_measured) return;
  m_original = shared(m_measured->factorization.factors.truncated(terms));
  const int active = activeIndex<FactorEdit>(m_document.state());
  if (active < 0) return refresh();
  FactorEdit edit = current();
  PdvFactors edited = edit.edited->truncated(terms);
  // Terms that the edit did not have yet come as they were found.
  if (FactorsWithCosts::Kind{edited.form, edited.transform} == m_requested &&
      edited.deviationNodes == m_original->deviationNodes)
    for (std::size_t c = 0; c < 3; ++c)
      for (auto i = edited.channels[c].size(); i < m_original->channels[c].size(); ++i)
        edited.channels[c].push_back(m_original->channels[c][i]);
  edit.original = m_original;
  edit.edited = shared(factorization::withRoomForEdits(edited));
  m_document.replaceEdits(
      editing::withEdit(m_document.edits(), std::size_t(active), [&](editing::Edit& one) { one.content = edit; }),
      terms == 1 ? tr("Use 1 term") : tr("Use %1 terms").arg(terms));
}

void FactorCurvesPanel::chooseForm() {
  forget();
  editing::EditList edits = m_document.edits();
  std::erase_if(edits, [](const auto& edit) { return std::holds_alternative<FactorEdit>(edit.content); });
  m_document.replaceEdits(std::move(edits), tr("Delete the edits of the factor curves"));
  request();
}

void FactorCurvesPanel::resetAll() {
  const int active = activeIndex<FactorEdit>(m_document.state());
  if (active >= 0)
    m_document.replaceEdits(editing::removed(m_document.edits(), std::size_t(active)), tr("Reset the factor curves"));
}

void FactorCurvesPanel::replaceCurve(FactorAxis axis, const QString& id) {
  const FactorEdit edit = current();
  if (!edit.edited) return;
  m_tasks.run<PdvFactors>(
      {tr("Transferring F%1 of %2").arg(int(axis) + 1).arg(id.section('/', -1)), swapKey},
      [id, edited = edit.edited](const TaskControl& control) {
        const auto table = materials::readMaterial(id.toStdString(), {control.stop, {}}).tabulated({control.stop, {}});
        factorization::PdvOptions options{.form = edited->form, .transform = edited->transform, .terms = 1};
        options.deviationNodes = edited->deviationNodes;
        return factorizePdv(*table, options, control).factors;
      },
      [this, axis, id](const PdvFactors& other) {
        const FactorEdit now = current();
        if (!now.edited) return;
        change(axis == FactorAxis::theta ? withF1Of(*now.edited, other) : withF2Of(*now.edited, other),
               tr("Use F%1 of %2").arg(int(axis) + 1).arg(id.section('/', -1)));
      },
      [this](const QString& error) { Q_EMIT failed(tr("Cannot use the curve"), error); });
}

}  // namespace gonio::app
