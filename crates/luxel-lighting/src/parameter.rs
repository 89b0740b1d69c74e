//! The numbers that reflection models depend on, each described once.

/// A number that a reflection model depends on.
///
/// Scene files, flags, sliders and documents use it.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Its key in scene files: `ka`.
    pub name: &'static str,
    /// As the equation writes it: `k_a`.
    pub symbol: &'static str,
    /// One line of help.
    pub help: &'static str,
    /// The smallest and the largest value.
    pub range: [f32; 2],
    /// Whether it takes whole numbers only.
    pub is_whole: bool,
    /// The largest value that sliders offer.
    pub slider_end: f32,
    /// The default value.
    pub default: f32,
    /// An example value, as in scene files.
    pub example: &'static str,
    /// The placeholder of its flag's value in help.
    pub placeholder: &'static str,
}

impl Parameter {
    /// A coefficient: 0 and more.
    const fn coefficient(name: &'static str, symbol: &'static str, help: &'static str) -> Self {
        let (range, default) = ([0.0, f32::INFINITY], 1.0);
        let (is_whole, slider_end, example, placeholder) = (false, 1.0, "1", "K");
        Self { name, symbol, help, range, is_whole, slider_end, default, example, placeholder }
    }

    /// A share: 0 to 1.
    const fn share(name: &'static str, help: &'static str) -> Self {
        let (range, placeholder) = ([0.0, 1.0], "SHARE");
        Self { range, placeholder, ..Self::coefficient(name, name, help) }
    }

    /// The nearest valid value; the default for NaN.
    #[must_use]
    pub fn nearest(&self, value: f32) -> f32 {
        let [low, high] = self.range;
        let value = if value.is_nan() { self.default } else { value.clamp(low, high) };
        if self.is_whole { value.round_ties_even() } else { value }
    }
}

/// k_a
pub const K_A: Parameter =
    Parameter::coefficient("ka", "k_a", "k_a: how much ambient light is reflected");

/// k_d
pub const K_D: Parameter = Parameter {
    example: "0.8",
    ..Parameter::coefficient("kd", "k_d", "k_d: how much light is reflected diffusely")
};

/// k_s
pub const K_S: Parameter = Parameter {
    default: 0.2,
    example: "0.4",
    ..Parameter::coefficient("ks", "k_s", "k_s: how much light is reflected in the highlight")
};

/// n
pub const SHININESS: Parameter = Parameter {
    placeholder: "N",
    slider_end: 200.0,
    default: 32.0,
    example: "60",
    ..Parameter::coefficient("shininess", "n", "n: the exponent of the highlight")
};

/// 0 for dielectrics, 1 for metals.
pub const METALLIC: Parameter = Parameter {
    default: 0.0,
    ..Parameter::share(
        "metallic",
        "0 to 1, for microfacet; replaces the texture of metalness and roughness",
    )
};

/// Perceptual roughness.
pub const ROUGHNESS: Parameter = Parameter {
    example: "0.35",
    ..Parameter::share(
        "roughness",
        "0 to 1, for microfacet and oren-nayar; replaces the texture of metalness and roughness",
    )
};

/// The parameters of every material, whatever its reflection model.
pub static SHARED: [&Parameter; 6] = [&K_A, &K_D, &K_S, &SHININESS, &ROUGHNESS, &METALLIC];
