//! What has a page of its own.

use sunglint::trial::{Method, Shading};

use crate::kernel::Kernel;

/// A method, or a building block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// A direction method.
    Direction(Method),
    /// `soft::cap`.
    Soft,
    /// A highlight method, as part of a lit pixel.
    Highlight(Shading),
    /// `raw::PixelQ14`.
    PixelQ14,
    /// A building block.
    Block(Kernel),
}

/// What the pages are sorted by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Ways to find the specular direction.
    Directions,
    /// Ways to light a pixel.
    Pixels,
    /// Their parts.
    Blocks,
}

impl Group {
    /// In the order of the page.
    pub const ALL: [Self; 3] = [Self::Directions, Self::Pixels, Self::Blocks];

    /// Heading.
    pub fn name(self) -> &'static str {
        match self {
            Self::Directions => "Directions",
            Self::Pixels => "Lit pixels",
            Self::Blocks => "Building blocks",
        }
    }

    /// What belongs to it.
    pub fn subjects(self) -> Vec<Subject> {
        match self {
            Self::Directions => Method::ALL.map(Subject::Direction).into_iter().chain([Subject::Soft]).collect(),
            Self::Pixels => Shading::ALL.map(Subject::Highlight).into_iter().chain([Subject::PixelQ14]).collect(),
            Self::Blocks => Kernel::ALL.map(Subject::Block).to_vec(),
        }
    }
}

impl Subject {
    /// Name, which the address of the page is made of.
    pub fn name(self) -> &'static str {
        match self {
            Self::Direction(method) => method.name(),
            Self::Soft => "soft::cap",
            Self::Highlight(shading) => shading.name(),
            Self::PixelQ14 => "PixelQ14",
            Self::Block(kernel) => kernel.name(),
        }
    }

    /// What its inputs were measured under.
    pub fn conditions(self) -> &'static str {
        match self {
            Self::Direction(_) | Self::Soft => "light",
            Self::Highlight(_) | Self::PixelQ14 => "light and roughness",
            Self::Block(_) => "",
        }
    }
}
