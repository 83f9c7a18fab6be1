//! The sources themselves. `tests/shaders` takes this file too, so that what it checks is what is given away.

/// A language that a snippet is in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// OpenGL's and Vulkan's.
    Glsl,
    /// Direct3D's.
    Hlsl,
    /// WebGPU's.
    Wgsl,
    /// The benchmark language of numerical tools.
    Fpcore,
}

/// Source code of a method.
#[derive(Clone, Copy, Debug)]
pub struct Snippet {
    /// Name of the method.
    pub method: &'static str,
    /// Its language.
    pub language: Language,
    /// Name of the file in `OUT/snippets`.
    pub file: &'static str,
    /// The code, with all that it calls.
    pub source: &'static str,
}

/// All of them, method by method.
pub const ALL: &[Snippet] = &[
    snippet(CAP, Language::Glsl, "cap.glsl", include_str!("cap.glsl")),
    snippet(CAP, Language::Hlsl, "cap.hlsl", include_str!("cap.hlsl")),
    snippet(CAP, Language::Wgsl, "cap.wgsl", include_str!("cap.wgsl")),
    snippet(CAP, Language::Fpcore, "cap.fpcore", include_str!("cap.fpcore")),
    snippet(CAP_HALF, Language::Glsl, "cap_half.glsl", include_str!("cap_half.glsl")),
    snippet(CAP_HALF, Language::Hlsl, "cap_half.hlsl", include_str!("cap_half.hlsl")),
    snippet(CAP_HALF, Language::Wgsl, "cap_half.wgsl", include_str!("cap_half.wgsl")),
    snippet(DISC_GGX, Language::Glsl, "disc_ggx_dir.glsl", DISC_GGX_GLSL),
    snippet(DISC_GGX, Language::Hlsl, "disc_ggx_dir.hlsl", DISC_GGX_HLSL),
    snippet(DISC_GGX, Language::Wgsl, "disc_ggx_dir.wgsl", DISC_GGX_WGSL),
    snippet(DISC_GGX, Language::Fpcore, "disc_ggx_dir.fpcore", include_str!("disc_ggx_dir.fpcore")),
    snippet(KARIS, Language::Glsl, "karis.glsl", KARIS_GLSL),
    snippet(KARIS, Language::Hlsl, "karis.hlsl", KARIS_HLSL),
    snippet(KARIS, Language::Wgsl, "karis.wgsl", KARIS_WGSL),
    snippet(KARIS, Language::Fpcore, "karis.fpcore", include_str!("karis.fpcore")),
];

const CAP: &str = "cap";
const CAP_HALF: &str = "cap_half";
const DISC_GGX: &str = "disc_ggx dir";
const KARIS: &str = "karis";

// What is called comes first, as GLSL and HLSL want it.
const DISC_GGX_GLSL: &str = concat!(include_str!("microfacet.glsl"), "\n", include_str!("disc_ggx_dir.glsl"));
const DISC_GGX_HLSL: &str = concat!(include_str!("microfacet.hlsl"), "\n", include_str!("disc_ggx_dir.hlsl"));
const DISC_GGX_WGSL: &str = concat!(include_str!("microfacet.wgsl"), "\n", include_str!("disc_ggx_dir.wgsl"));
const KARIS_GLSL: &str =
    concat!(include_str!("cap.glsl"), "\n", include_str!("microfacet.glsl"), "\n", include_str!("karis.glsl"));
const KARIS_HLSL: &str =
    concat!(include_str!("cap.hlsl"), "\n", include_str!("microfacet.hlsl"), "\n", include_str!("karis.hlsl"));
const KARIS_WGSL: &str =
    concat!(include_str!("cap.wgsl"), "\n", include_str!("microfacet.wgsl"), "\n", include_str!("karis.wgsl"));

const fn snippet(method: &'static str, language: Language, file: &'static str, source: &'static str) -> Snippet {
    Snippet { method, language, file, source }
}
