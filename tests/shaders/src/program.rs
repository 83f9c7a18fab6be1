//! Snippets as modules of naga, with an entry point around them.

use naga::front::{glsl, wgsl};
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use naga::{Module, ShaderStage};

use crate::sources::Language;

/// A module that has been validated.
pub struct Program {
    /// The module.
    pub module: Module,
    /// What the validator has found out.
    pub info: ModuleInfo,
}

impl Program {
    /// Parses and validates WGSL; the message of naga where it is wrong.
    pub fn wgsl(source: &str) -> Result<Self, String> {
        let module = wgsl::parse_str(source).map_err(|error| error.emit_to_string(source))?;
        Self::validated(module)
    }

    /// Parses and validates GLSL of a fragment shader.
    pub fn glsl(source: &str) -> Result<Self, String> {
        let options = glsl::Options::from(ShaderStage::Fragment);
        let module = glsl::Frontend::default().parse(&options, source).map_err(|error| error.emit_to_string(source))?;
        Self::validated(module)
    }

    fn validated(module: Module) -> Result<Self, String> {
        let capabilities = Capabilities::SHADER_FLOAT16;
        let info = Validator::new(ValidationFlags::all(), capabilities)
            .validate(&module)
            .map_err(|error| format!("{error:?}"))?;
        Ok(Self { module, info })
    }
}

/// Functions as a whole fragment shader that calls one of them.
pub fn whole(language: Language, functions: &str, stem: &str) -> String {
    let call = call(language, stem);
    match language {
        Language::Glsl => format!(
            "#version 450\nlayout(location = 0) in vec3 a;\nlayout(location = 1) in vec3 b;\n\
             layout(location = 2) in vec3 c;\nlayout(location = 0) out vec4 color;\n{functions}\n\
             void main() {{\n    color = vec4({call}, 1.0);\n}}\n"
        ),
        Language::Hlsl => format!(
            "{functions}\nfloat4 main(float3 a : A, float3 b : B, float3 c : C) : SV_Target {{\n    \
             return float4({call}, 1.0);\n}}\n"
        ),
        Language::Wgsl => format!(
            "{functions}\n@fragment\nfn main(@location(0) a: vec3f, @location(1) b: vec3f, @location(2) c: vec3f) \
             -> @location(0) vec4f {{\n    return vec4f(vec3f({call}), 1.0);\n}}\n"
        ),
        Language::Fpcore => panic!("FPCore is no shader"),
    }
}

/// A call of the function of a snippet, by its file's name without the ending.
fn call(language: Language, stem: &str) -> String {
    let call = match stem {
        "cap" => "cap(a, b, 0.00465, versine(0.00465))",
        "cap_half" => "cap_half(HALF3(a), HALF3(b), HALF(0.00465), HALF(0.0000108))",
        "disc_ggx_dir" => "lit_pixel(a, b, c, 0.0000108, 0.0625, a, b, c)",
        "karis" => "karis_ggx(a, b, c, 0.00465, versine(0.00465), 0.0625, a)",
        _ => panic!("no call of {stem}"),
    };
    let [vector, number] = match language {
        Language::Hlsl => ["min16float3", "min16float"],
        Language::Wgsl => ["vec3h", "f16"],
        _ => ["vec3", "float"],
    };
    call.replace("HALF3", vector).replace("HALF", number)
}
