# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Factors, codes, blends."""
import numpy as np
import pytest

import gonio


@pytest.fixture(scope="module")
def factors(paint):
    return gonio.factorize(paint, terms=3)


def test_residuals_fall_and_terms_are_nested(paint, factors):
    assert factors.terms == 3 and len(factors.residuals) == 4
    assert factors.residuals[0] == 1 and np.all(np.diff(factors.residuals) <= 0)
    one = gonio.factorize(paint, terms=1, deviation_nodes=factors.deviation_nodes)
    np.testing.assert_array_equal(factors.truncated(1).f1, one.f1)


def test_factors_evaluate_as_their_formula(factors):
    """y = sum_l F1 F2 F3 at the nodes, rho = exp(y) - 1 (log-plus): in the plane of incidence with the mirror direction."""
    curve = factors.theta_nodes < 1.2
    theta = factors.theta_nodes[curve]
    y = (factors.f1[:, :, curve] * factors.f2[:, :, :1] * factors.f3[:, :, :1]).sum(axis=1)
    wo = np.stack((np.sin(theta), 0 * theta, np.cos(theta)), axis=-1)
    np.testing.assert_allclose(factors.material().evaluate(wo * [-1, 1, 1], wo), np.expm1(np.maximum(0, y)).T, rtol=1e-6)


def test_factor_files_round_trip(factors, tmp_path):
    factors.save(tmp_path / "paint.pdv")
    assert (tmp_path / "paint.pdv").stat().st_size == factors.bytes
    again = gonio.open_factors(tmp_path / "paint.pdv")
    np.testing.assert_array_equal(again.f2, factors.f2.astype(np.float32))
    assert gonio.open(tmp_path / "paint.pdv").format == "PDV factors"


def test_edits_of_curves(paint, factors):
    same = gonio.edit_factors(paint, factors, factors.with_curves(f1=factors.f1))
    np.testing.assert_array_equal(same.values, paint.values)
    stronger = gonio.edit_factors(paint, factors, factors.with_curves(f1=factors.f1 * 1.2))
    assert stronger.values.sum() > paint.values.sum()
    with pytest.raises(gonio.Error, match="f1"):
        factors.with_curves(f1=factors.f1[:, :, 1:])


def test_huge_curves_are_warned_about(paint, factors):
    """Values stay finite; the material made of the curves, and one edited with them, state the limit."""
    f1 = factors.f1
    f1[0, 0, 3] = 1e300
    huge = factors.with_curves(f1=f1)
    for material in (huge.material(), gonio.edit_factors(paint, factors, huge)):
        assert any("larger than 1e+30 (1e+300 in F1 of term 1 in red)" in note for note in material.notes)
        assert np.all(np.isfinite(material.evaluate([0, 0, 1], [0, 0, 1])))
    assert not factors.material().notes


def test_lost_peaks_are_warned_about():
    """One cell of 1e8 in a grey table cannot survive with few coefficients; the grey table loses nothing."""
    shape = (90, 90, 180)
    nodes = gonio.grid_directions(shape)
    values = np.full(shape + (3,), 0.1)
    grey = gonio.from_table(values, nodes.valid)
    assert gonio.encode(grey, coefficients=16).warnings == []
    values[2, 40, 90, 0] = 1e8
    warnings = gonio.encode(gonio.from_table(values, nodes.valid), coefficients=2).warnings
    assert len(warnings) == 1 and "the brightest cell in red" in warnings[0]


def test_bad_factorisations_are_errors(paint):
    for options in ({"terms": 0}, {"form": "4d"}, {"transform": "square"}, {"deviation_nodes": [0, 0, 1]}):
        with pytest.raises(gonio.Error):
            gonio.factorize(paint, **options)


def test_baselines(paint):
    assert {"kautz-mccool", "bivariate", "cp", "hosvd", "nmf"} <= set(gonio.baselines())
    for method in ("kautz-mccool", "bivariate", "hosvd"):
        few, many = (gonio.factorize_baseline(paint, method, bytes=size) for size in (4000, 40000))
        assert 0 < few.bytes <= 4000 < many.bytes <= 40000 and many.seconds > 0
        errors = [gonio.compare(paint, found.material, size=16, samples=4).errors["log"] for found in (few, many)]
        assert errors[1] < errors[0]
    for arguments in (("wish", 5000), ("cp", 0)):
        with pytest.raises(gonio.Error):
            gonio.factorize_baseline(paint, *arguments)


@pytest.fixture(scope="module")
def code():
    return gonio.encode(gonio.open("library:sgd/blue-metallic-paint"), coefficients=64, transforms=["log-plus"])


def test_codes_are_sums_of_atoms(code):
    """The transformed values of the decoded table are the sum over the coefficients of products of atoms, but for the scale
    of the nodes: the ratio to it is one function of the node for all channels."""
    dictionary = gonio.dictionary()
    with pytest.raises(gonio.Error, match=f"number: found {len(dictionary)}, expected 0 to {len(dictionary) - 1}"):
        dictionary.atoms(len(dictionary))
    values = code.material().values
    ratios = []
    for c, channel in enumerate(code.channels):
        phi, theta_d, theta_h = dictionary.atoms(channel.dictionary)
        assert np.all(np.diff(np.abs(channel.values)) <= 0) and len(channel.values) <= 64
        i = channel.indices
        at = (slice(5, 80, 15), slice(5, 60, 15), slice(10, 170, 40))
        signal = np.einsum("n,hn,dn,pn->hdp", channel.values.astype(float), theta_h[at[0]][:, i[:, 2]], theta_d[at[1]][:, i[:, 1]],
                           phi[at[2]][:, i[:, 0]])
        ratios.append(np.log1p(values[at][..., c]) / signal)
    valid = code.material().valid[at]
    np.testing.assert_allclose(ratios[0][valid], ratios[1][valid], rtol=1e-3)


def test_codes_by_other_methods(code, tmp_path):
    paint = gonio.open("library:sgd/blue-metallic-paint")
    options = {"coefficients": 64, "transforms": ["log-plus"]}
    convex = gonio.encode(paint, method="basis-pursuit", **options)
    published = gonio.encode(paint, as_published=True, **options)
    assert code.scaled and convex.scaled and not published.scaled
    assert len(convex.channels[0].values) <= 64
    # Without the scale the decoded transformed values are the sums of atoms themselves.
    channel = published.channels[1]
    atoms = published.dictionary.atoms(channel.dictionary)
    nodes = (20, 30, 60)
    signal = sum(value * atoms[0][nodes[2], i[0]] * atoms[1][nodes[1], i[1]] * atoms[2][nodes[0], i[2]]
                 for value, i in zip(channel.values.astype(float), channel.indices))
    np.testing.assert_allclose(published.material().values[nodes][1], np.expm1(max(signal, 0)), rtol=1e-3, atol=1e-5)
    published.save(tmp_path / "published.code")
    np.testing.assert_array_equal(gonio.decode(tmp_path / "published.code").values, published.material().values)
    for wrong in ({"method": "lars"}, {"method": "basis-pursuit", "as_published": True}):
        with pytest.raises(gonio.Error, match="method"):
            gonio.encode(paint, **wrong)


def test_joint_factors(paint, factors):
    joint = gonio.factorize(paint, terms=3, joint=True)
    assert joint.residuals[3] < factors.residuals[3] and joint.bytes == factors.bytes
    np.testing.assert_array_equal(joint.residuals[:3], factors.residuals[:3])
    assert joint.f1[:, 0].min() >= 0


def test_compact_factors(paint, factors):
    compact = gonio.factorize(paint, terms=3, compact=True)
    assert compact.theta_nodes.size == 60 and compact.phi_nodes.size == 30
    assert compact.bytes < 0.55 * factors.bytes and compact.residuals[3] < 1.1 * factors.residuals[3]


def test_code_files_round_trip(code, tmp_path):
    code.save(tmp_path / "paint.code")
    assert (tmp_path / "paint.code").stat().st_size == code.bytes
    np.testing.assert_array_equal(gonio.decode(tmp_path / "paint.code").values, code.material().values)


def test_codes_without_a_table(code, directions):
    """At the nodes both forms agree."""
    nodes = gonio.grid_directions()
    table, own = code.material(), code.material(as_table=False)
    assert table.is_table and not own.is_table
    at = (slice(5, 60, 10), slice(5, 45, 10), slice(10, 170, 40))
    valid = nodes.valid[at]
    np.testing.assert_allclose(own.evaluate(nodes.wi[at], nodes.wo[at])[valid], table.values[at][valid], rtol=2e-3, atol=1e-5)


def test_linear_blends_are_means(chrome, paint, directions):
    wi, wo = directions(100), directions(100, seed=2)
    blends = gonio.Interpolation([chrome, paint])
    expected = 0.25 * chrome.evaluate(wi, wo) + 0.75 * paint.evaluate(wi, wo)
    np.testing.assert_allclose(blends.blend([0.25, 0.75]).evaluate(wi, wo), expected, rtol=1e-6, atol=1e-9)
    np.testing.assert_array_equal(blends.blend([0, 1]).values, paint.values)


def test_factors_as_published(paint):
    nodes = gonio.published_deviation_nodes()
    assert nodes.shape == (90,) and nodes[0] == 0 and np.all(np.diff(nodes) > 0) and nodes[-1] < 2
    published = gonio.factorize(paint, terms=2, form="2d", weights="equal", deviation_nodes=nodes)
    np.testing.assert_array_equal(published.deviation_nodes, nodes)
    ours = gonio.factorize(paint, terms=2, form="2d", deviation_nodes=nodes)
    assert not np.array_equal(ours.f1, published.f1)
    own = gonio.published_deviation_nodes([paint, paint])
    np.testing.assert_allclose(own, gonio.published_deviation_nodes([paint]), atol=1e-9)
    assert not np.array_equal(own, nodes)
    with pytest.raises(gonio.Error, match="weights"):
        gonio.factorize(paint, weights="even")


@pytest.mark.parametrize("space", ["parameters", "differential"])
def test_ends_of_other_spaces_are_the_materials(chrome, paint, space):
    np.testing.assert_array_equal(gonio.interpolate([chrome, paint], [1, 0], space).values, chrome.values)


def test_blends_keep_measured_detail(chrome, paint, directions):
    wi, wo = directions(100), directions(100, seed=2)
    near, kept = [
        gonio.interpolate([chrome, paint], [0.9999, 0.0001], "parameters", model="lambert", keep_detail=keep).evaluate(wi, wo)
        for keep in (False, True)]
    own = chrome.evaluate(wi, wo)
    assert np.max(np.abs(kept - own) / (1 + own)) < 0.01 < np.max(np.abs(near - own) / (1 + own))


def test_bad_blends_are_errors(chrome, paint):
    with pytest.raises(gonio.Error, match="space"):
        gonio.interpolate([chrome, paint], [0.5, 0.5], "cubic")
    with pytest.raises(gonio.Error):
        gonio.interpolate([chrome, paint], [0.5, 0.6])


def test_dictionaries_are_trained(chrome, paint, tmp_path, goniotool):
    for material in (chrome, paint):
        material.save(tmp_path / f"{material.name}.binary")
    options = {"dictionaries": 1, "sparsities": [16, 32], "iterations": 2}
    fractions = []
    trained = gonio.train_dictionary([tmp_path], tmp_path / "own.dictionary", progress=fractions.append, **options)
    assert len(trained) == 2 and sorted(trained.training_set) == sorted([chrome.name, paint.name])
    assert fractions and fractions[-1] <= 1
    for mode in trained.atoms(1):
        np.testing.assert_allclose(mode.T @ mode, np.eye(mode.shape[1]), atol=1e-5)
    assert len(gonio.encode(paint, coefficients=16, dictionary=trained).channels[0].values) <= 16
    # The command line learns the same.
    goniotool("dictionary", "train", tmp_path, "--out", tmp_path / "other.dictionary", "--dictionaries", 1, "--sparsities", "16,32",
              "--iterations", 2)
    assert gonio.dictionary(tmp_path / "other.dictionary").id == trained.id
    longer = gonio.train_dictionary([tmp_path], tmp_path / "longer.dictionary", extend=tmp_path / "own.dictionary", normalise=True,
                                    dictionaries=1, sparsities=[16], iterations=2)
    assert len(longer) == 3
    for mode, first in zip(longer.atoms(1), trained.atoms(1)):  # orthonormal again after they are rounded again
        np.testing.assert_allclose(mode, first, atol=1e-6)
    goniotool("dictionary", "train", tmp_path, "--out", tmp_path / "other.dictionary", "--dictionaries", 1, "--sparsities", "16",
              "--iterations", 2, "--extend", tmp_path / "own.dictionary", "--normalise")
    assert gonio.dictionary(tmp_path / "other.dictionary").id == longer.id
    with pytest.raises(gonio.Error, match="patches"):  # their grid is no multiple
        gonio.learn_patches([tmp_path])
    with pytest.raises(gonio.Error):
        gonio.train_dictionary([tmp_path], tmp_path / "none.dictionary", excluded=["absent"])
    assert not (tmp_path / "none.dictionary").exists()
