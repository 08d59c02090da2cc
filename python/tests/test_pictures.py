# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Pictures, comparisons, studies, exports."""
import numpy as np
import pytest

import gonio


def test_a_lambertian_sphere_is_lit_as_its_formula(tmp_path):
    """Under one distant light of irradiance pi the radiance is albedo times the cosine: at the brightest point the albedo."""
    lambert = gonio.models()["lambert"].material(diffuse=0.5)
    picture = gonio.render(lambert, "sphere", size=64, samples=16, alpha=True)
    assert picture.shape == (64, 64, 4) and picture.dtype == np.float32
    assert picture[0, 0, 3] == 0 and picture[32, 32, 3] == 1
    wide = gonio.render(lambert, "sphere", size=(24, 16), samples=4)
    assert wide.shape == (16, 24, 3)
    np.testing.assert_array_equal(wide, gonio.render(lambert, "sphere", size=(24, 16), samples=4))


def test_a_white_sphere_in_a_white_room_is_white(tmp_path):
    """White furnace: in an environment of radiance 1 a Lambertian sphere of albedo 1 has radiance 1 everywhere."""
    (tmp_path / "white.hdr").write_bytes(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n" + bytes([128, 128, 128, 129] * 32))
    white = gonio.models()["lambert"].material(diffuse=1.0)
    picture = gonio.render(white, "sphere", size=32, samples=64, environment=tmp_path / "white.hdr", alpha=True)
    inside = picture[..., 3] == 1
    np.testing.assert_allclose(picture[inside][:, :3], 1, rtol=0.05)


def test_every_sampling_method_has_the_same_mean(paint):
    """All densities estimate the same image; only their noise differs."""
    expected = gonio.render(paint, "sphere", size=24, samples=256).mean()
    for method in ("pdv", "lawrence", "bilgili", "ggx", "cosine"):
        assert gonio.render(paint, "sphere", size=24, samples=64, sampling=method).mean() == pytest.approx(expected, rel=0.02), method
    with pytest.raises(gonio.Error, match="sampling: found 'best', expected one of auto, pdv, published"):
        gonio.render(paint, "sphere", size=8, samples=1, sampling="best")


def test_effects_have_reasons(chrome):
    effects = {effect.name: effect for effect in gonio.effects(chrome)}
    assert not effects["cast-shadows"].simulated and effects["cast-shadows"].reason


def test_bad_scenes_are_errors(chrome):
    assert "sphere" in gonio.scenes()
    with pytest.raises(gonio.Error, match="nowhere"):
        gonio.render(chrome, "nowhere")
    with pytest.raises(gonio.Error, match="at most 1"):
        gonio.render([chrome, chrome], "sphere", size=8, samples=1)


def test_meshes_stand_upright(chrome, tmp_path):
    """A box of 1 x 2 x 4 along x, y, z with z up is the same picture as the box of 1 x 4 x 2 whose y axis is -z of the first."""
    faces = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
    (tmp_path / "z.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 4\n" + faces)
    (tmp_path / "y.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 0 -2\nv 0 4 0\n" + faces)
    lying, standing, expected = (gonio.render(chrome, tmp_path / name, size=24, samples=4, up=up)
                                 for name, up in (("z.obj", "y"), ("z.obj", "z"), ("y.obj", "y")))
    np.testing.assert_array_equal(standing, expected)
    assert not np.array_equal(lying, expected)
    assert gonio.effects(chrome, tmp_path / "z.obj", up="z")
    for scene, up, message in (("sphere", "z", "expected a mesh file"), (tmp_path / "z.obj", "x", "expected y or z")):
        with pytest.raises(gonio.Error, match=message):
            gonio.render(chrome, scene, size=8, samples=1, up=up)


def test_comparison(chrome, paint):
    same = gonio.compare(chrome, chrome, size=16, samples=4)
    assert same.rendered_snr == np.inf and same.brdf_snr == np.inf and max(same.errors.values()) == 0
    assert same.pictures is None
    # Half as bright: the difference has half the amplitude of the signal, 6.02 dB.
    half = gonio.compare(chrome, gonio.from_table(chrome.values / 2, chrome.valid), size=16, samples=4, pictures=True)
    assert half.brdf_snr == pytest.approx(20 * np.log10(2), abs=1e-3)
    assert half.rendered_snr == pytest.approx(20 * np.log10(2), abs=0.1)
    np.testing.assert_allclose(half.pictures[1], half.pictures[0] / 2, rtol=1e-3, atol=1e-6)
    assert set(half.errors) == set(gonio.metrics())
    reference, test = (picture.astype(float) for picture in half.pictures)
    assert half.image_metrics["mse"] == pytest.approx(np.mean((reference - test) ** 2))
    assert half.image_metrics["log-mse"] == pytest.approx(np.mean((np.log1p(reference) - np.log1p(test)) ** 2))
    assert 0 < half.image_metrics["ssim"] < 1 and 0 < half.image_metrics["flip"] < 1 and half.image_metrics["ciede2000"] > 1
    assert same.image_metrics == {"mse": 0, "log-mse": 0, "relative-mse": 0, "ssim": 1, "flip": 0, "ciede2000": 0}


def test_study_measures_its_budgets(paint):
    records = gonio.study(paint, ["table", "fits", "factors"], models=["lambert"], terms=[1, 2], size=16, samples=4, timed=False)
    assert [record.budget for record in records if record.representation == "factors-3d"] == [1, 2]
    factors = [record for record in records if record.representation == "factors-3d"]
    assert factors[0].bytes < factors[1].bytes and factors[0].errors["log"] > factors[1].errors["log"]
    table = next(record for record in records if record.representation == "table-trilinear")
    assert table.errors["log"] == 0
    with pytest.raises(gonio.Error, match="fits"):
        gonio.study(paint, ["nothing"])


def test_study_of_baselines_and_components(paint):
    records = gonio.study(paint, ["baselines"], baselines=["bivariate", "mccool"], terms=[1, 3], size=16, samples=4, timed=False)
    assert [(record.representation, record.budget) for record in records] == [("mccool", 0), ("bivariate", 5800), ("bivariate", 14440)]
    factors = gonio.factorize_baseline(paint, "bivariate", bytes=14440)
    assert records[2].bytes == factors.bytes
    assert records[2].errors == gonio.compare(paint, factors.material, size=16, samples=4).errors
    with pytest.raises(gonio.Error, match="nonparametric"):
        gonio.study(paint, ["baselines"], baselines=["nonparametric"])
    with pytest.raises(gonio.Error, match="components"):
        gonio.study(paint, ["components"], components=[1])
    with pytest.raises(gonio.Error, match="patches"):
        gonio.study(paint, ["patches"], coefficients=[1])


def test_study_of_published_factors(paint, chrome, tmp_path):
    row = np.zeros((512, 3), np.float32)
    row[0], row[1], row[2:92], row[93:183], row[183:273] = 0.2, 3, np.exp(-0.1 * np.arange(90))[:, None], 1, 1
    row.tofile(tmp_path / "npf.bin")
    (tmp_path / "npf_row_order.csv").write_text("row,material\n0,chrome\n")
    options = dict(representations=["table"], npf=tmp_path / "npf.bin", size=16, samples=4, timed=False)
    record = gonio.study(chrome, **options)[-1]
    assert (record.family, record.representation, record.bytes) == ("published-nonparametric", "published-nonparametric", 3264)
    assert np.isnan(record.encode_seconds)
    expected = gonio.compare(chrome, gonio.open(f"{tmp_path}/npf.bin#chrome"), size=16, samples=4)
    assert record.errors == expected.errors and record.rendered_snr == expected.rendered_snr
    # A material without a row has no such record.
    assert {record.family for record in gonio.study(paint, **options)} == {"table"}
    with pytest.raises(gonio.Error, match="published non-parametric factors"):
        gonio.study(chrome, ["published-nonparametric"])
    with pytest.raises(gonio.Error, match="absent.bin"):
        gonio.study(chrome, npf=tmp_path / "absent.bin")


def test_export_writes_what_it_says(paint, tmp_path):
    assert {"mitsuba", "blender"} <= set(gonio.targets())
    made = gonio.export(paint, tmp_path / "paint", "csv")
    assert made.files and sum((tmp_path / name).stat().st_size for name in made.files) == made.bytes
    # Values at some directions are no material.
    assert made.material is None and np.isnan(made.snr) and np.isnan(made.brdf_snr) and "nothing between" in made.losses[0]
    table = gonio.export(paint, tmp_path / "table", "merl")
    np.testing.assert_array_equal(table.material.evaluate([0, 0, 1.0], [0, 0.6, 0.8]), gonio.open(tmp_path / "table.binary").evaluate([0, 0, 1.0], [0, 0.6, 0.8]))
    with pytest.raises(gonio.Error, match="paint"):
        gonio.export(paint, tmp_path / "paint", "csv")
    gonio.export(paint, tmp_path / "paint", "csv", overwrite=True)
    with pytest.raises(gonio.Error, match="target"):
        gonio.export(paint, tmp_path / "other", "nothing")
