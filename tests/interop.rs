//! The traits of other crates: what is stored is read back to the bit or refused, what is logged arrives as it is, what
//! lies in memory is bytes.

mod stored {
    use std::fmt::Debug;

    use serde::de::DeserializeOwned;
    use serde::{Deserialize, Serialize};
    use sunglint::light::Description;
    use sunglint::material::{LEAST_ALPHA, Material};
    use sunglint::radiometry::SphereLight;
    use sunglint::scene::{Channel, Lamp, Scene};
    use sunglint::{DistantLight, DistantSphere, LightError, SUN};

    fn json(value: impl Serialize) -> String {
        serde_json::to_string(&value).unwrap()
    }

    fn read<T: DeserializeOwned + Debug>(text: &str) -> Result<T, String> {
        serde_json::from_str(text).map_err(|error| error.to_string())
    }

    /// Numbers with digits to lose, from a fixed seed.
    fn numbers() -> impl Iterator<Item = f64> {
        let mut state = 0x9e37_79b9_7f4a_7c15_u64;
        std::iter::repeat_with(move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        })
        .take(1000)
    }

    fn bits(light: &DistantLight) -> [u64; 5] {
        [light.sin(), light.cos(), light.versine(), light.radius(), light.distance()].map(f64::to_bits)
    }

    fn comes_back(light: Result<DistantLight, LightError>) {
        let light = light.unwrap();
        let again: DistantLight = read(&json(light)).unwrap();
        assert_eq!((bits(&again), again.description()), (bits(&light), light.description()));
    }

    #[test]
    fn lights_come_back_to_the_bit() {
        for x in numbers().chain([0.0, -0.0, f64::MIN_POSITIVE, 5e-324, 1.0]) {
            comes_back(DistantLight::from_ratio(x));
            comes_back(DistantLight::from_radius_and_distance(x, 1.0 + x / 3.0));
            comes_back(DistantLight::from_radius_and_distance(x * 1e300, 1.7e308));
            comes_back(DistantLight::from_angular_radius(x * std::f64::consts::PI));
            comes_back(DistantLight::from_angle(x * 360.0));
        }
        comes_back(Ok(SUN));
    }

    #[test]
    fn lights_are_written_as_they_were_described() {
        assert_eq!(json(SUN), r#"{"radius_and_distance":{"radius":695700.0,"distance":149597870.7}}"#);
        assert_eq!(json(DistantLight::from_ratio(0.05).unwrap()), r#"{"ratio":0.05}"#);
        assert_eq!(json(DistantLight::from_angle(0.53).unwrap()), r#"{"angle":0.53}"#);
        assert_eq!(json(DistantLight::from_angular_radius(0.25).unwrap()), r#"{"angular_radius":0.25}"#);
        assert_eq!(json(Description::from(SUN)), json(SUN));
    }

    #[test]
    fn lights_of_equal_numbers_are_equal() {
        let half = DistantLight::from_ratio(0.5).unwrap();
        assert_eq!(Ok(half), DistantLight::from_radius_and_distance(0.5, 1.0));
        assert_ne!(Ok(half), DistantLight::from_radius_and_distance(1.0, 2.0));
        assert_eq!([half.radius(), half.distance()], [0.5, 1.0]);
    }

    fn refused<T: DeserializeOwned + Debug>(text: &str, why: &str) {
        let found = read::<T>(text).unwrap_err();
        assert!(found.starts_with(why), "{text}: {found}");
    }

    #[test]
    fn what_no_light_is_is_refused_with_the_constructors_words() {
        for (text, error) in [
            (r#"{"ratio":1.5}"#, DistantLight::from_ratio(1.5)),
            (r#"{"ratio":-0.5}"#, DistantLight::from_ratio(-0.5)),
            (r#"{"angle":361.0}"#, DistantLight::from_angle(361.0)),
            (r#"{"angular_radius":3.5}"#, DistantLight::from_angular_radius(3.5)),
            (
                r#"{"radius_and_distance":{"radius":2.0,"distance":1.0}}"#,
                DistantLight::from_radius_and_distance(2.0, 1.0),
            ),
            (
                r#"{"radius_and_distance":{"radius":0.0,"distance":0.0}}"#,
                DistantLight::from_radius_and_distance(0.0, 0.0),
            ),
        ] {
            refused::<DistantLight>(text, &error.unwrap_err().to_string());
        }
        refused::<DistantLight>(r#"{"sin":0.5}"#, "unknown variant `sin`, expected one of `ratio`");
        refused::<DistantLight>(r#"{"radius_and_distance":{"radius":0.5}}"#, "missing field `distance`");
        let misspelt = r#"{"radius_and_distance":{"radius":0.5,"distance":1.0,"angel":2.0}}"#;
        refused::<DistantLight>(misspelt, "unknown field `angel`");
        refused::<DistantLight>(r#"{"ratio":null}"#, "invalid type: null, expected f64");
    }

    #[test]
    fn materials_come_back_to_the_bit_or_are_refused() {
        for x in numbers() {
            let material = Material::new([x, 1.0 - x, x / 3.0], x.max(LEAST_ALPHA), [x * x, 0.0, 1.0]).unwrap();
            assert_eq!(read(&json(material)), Ok(material));
        }
        let sea = r#"{"albedo":[0.01,0.03,0.05],"alpha":0.02,"f0":[0.02,0.02,0.02]}"#;
        assert_eq!(json(read::<Material>(sea).unwrap()), sea);
        refused::<Material>(&sea.replace("0.05", "1.05"), "albedo is 1.05, allowed is 0 to 1");
        refused::<Material>(
            &sea.replace("\"alpha\":0.02", "\"alpha\":0.0001"),
            "alpha is 0.0001, allowed is 0 or 0.0005 to 1",
        );
        refused::<Material>(&sea.replace("[0.02,", "[-0.02,"), "reflectance at normal incidence is -0.02");
        refused::<Material>(&sea.replace("}", ",\"roughness\":0.1}"), "unknown field `roughness`");
        refused::<Material>(&sea.replace("alpha", "alhpa"), "unknown field `alhpa`");
    }

    #[test]
    fn small_spheres_come_back_to_the_bit_or_are_refused() {
        for x in numbers().filter(|&x| x > 0.0) {
            let light = SphereLight::of_point([x, 1.0, 3.0], [0.0; 3], x / 7.0, [x, 0.5, 1.0 / 3.0]).unwrap();
            assert_eq!(read(&json(light)), Ok(light));
            let [x, ratio] = [x, x / 3.0].map(|x| x as f32 + f32::MIN_POSITIVE);
            let light = SphereLight::of_direction([x, 1.0, 3.0], 100.0, ratio, [x, 0.5, 1.0]).unwrap();
            assert_eq!(read(&json(light)), Ok(light));
        }
        let lamp = r#"{"centre":[0.0,0.0,2.0],"radius":0.5,"distance":2.0,"colour":[1.0,1.0,1.0]}"#;
        assert_eq!(json(read::<SphereLight<f32>>(lamp).unwrap()), lamp);
        refused::<SphereLight<f32>>(&lamp.replace("0.5", "2.5"), "radius is 2.5, allowed is up to the distance 2");
        refused::<SphereLight<f32>>(&lamp.replace("1.0]", "-1.0]"), "colour is -1");
    }

    #[test]
    fn channels_have_names() {
        assert_eq!(json([Channel::Red, Channel::Green, Channel::Blue]), r#"["red","green","blue"]"#);
        assert_eq!(read(r#""blue""#), Ok(Channel::Blue));
        refused::<Channel>(r#""Blue""#, "unknown variant `Blue`");
    }

    /// What a user would write: a scene as a file has it, and made.
    #[derive(Debug, Deserialize)]
    struct File {
        surface: Material,
        lights: Vec<Entry>,
    }

    #[derive(Debug, Deserialize)]
    struct Entry {
        light: DistantLight,
        direction: [f32; 3],
        illuminance: [f32; 3],
    }

    #[test]
    fn a_scene_file() {
        let text = r#"{
            "surface": { "albedo": [0.01, 0.03, 0.05], "alpha": 0.02, "f0": [0.02, 0.02, 0.02] },
            "lights": [{ "light": { "angle": 0.53 }, "direction": [0.6, 0.0, 0.8], "illuminance": [3.0, 2.0, 1.0] }]
        }"#;
        let file: File = read(text).unwrap();
        let mut scene = Scene::<f32, 1>::new(&sunglint::material::Surface::of(&file.surface));
        for Entry { light, direction, illuminance } in file.lights {
            scene.push(&Lamp::new(direction, DistantSphere::of(&light), illuminance).unwrap()).unwrap();
        }
        let [red, green, blue] = scene.shade([0.0, 0.0, 1.0], [-0.6, 0.0, 0.8]);
        assert!(red > green && green > blue && blue > 1.0);
    }
}

mod logged {
    use std::cell::RefCell;

    use sunglint::plain::VectorQ14;
    use sunglint::raw::SUN_Q14;
    use sunglint::real::{Constant, Scalar, Scaled};
    use sunglint::{LightError, SUN};

    thread_local! {
        static FRAME: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    }

    #[defmt::global_logger]
    struct Captured;

    // SAFETY: a frame is written by one thread into a vector of its own, so none is interleaved with another.
    unsafe impl defmt::Logger for Captured {
        fn acquire() {}
        unsafe fn flush() {}
        unsafe fn release() {}
        unsafe fn write(bytes: &[u8]) {
            FRAME.with_borrow_mut(|frame| frame.extend(bytes));
        }
    }

    defmt::timestamp!("");

    /// What goes over the wire: numbers in binary, and of texts and types the numbers that the host knows them by.
    fn sent(value: impl defmt::Format) -> Vec<u8> {
        defmt::println!("{}", value);
        FRAME.take()
    }

    /// Whether `numbers` are sent, one after the other.
    fn holds<const N: usize>(frame: &[u8], numbers: impl IntoIterator<Item = [u8; N]>) -> bool {
        let mut rest = frame;
        numbers.into_iter().all(|number| {
            let place = rest.windows(N).position(|window| window == number);
            place.inspect(|place| rest = &rest[place + N..]).is_some()
        })
    }

    #[test]
    fn numbers_are_sent_as_they_are() {
        assert!(holds(&sent(SUN_Q14), SUN_Q14.to_array().map(i32::to_le_bytes)));
        assert!(!holds(&sent(SUN_Q14), [0x1234_5678_i32.to_le_bytes()]));
        let vector = VectorQ14 { x: 1234, y: -2345, z: 16_384 };
        assert!(holds(&sent(vector), [1234_i16, -2345, 16_384].map(i16::to_le_bytes)));
        assert!(holds(&sent(Constant::new(0.1)), [0.1_f64.to_le_bytes()]));
        assert!(holds(&sent(LightError::Ratio(1.1)), [1.1_f64.to_le_bytes()]));
        assert!(holds(
            &sent(SUN),
            [SUN.sin(), SUN.cos(), SUN.versine(), SUN.radius(), SUN.distance()].map(f64::to_le_bytes)
        ));
    }

    #[test]
    fn scaled_numbers_are_sent_as_two_integers() {
        for value in [1.0, 0.1, -3.0, 1e9, -1e-9] {
            let scaled = Scaled::new(value);
            let frame = sent(scaled);
            // Two bytes end what a type formats by itself.
            let (numbers, _) = frame.split_last_chunk::<2>().unwrap();
            let [mantissa, exponent] =
                [8, 4].map(|back| i32::from_le_bytes(*numbers[numbers.len() - back..].first_chunk().unwrap()));
            assert_eq!(f64::from(mantissa) * f64::from(exponent).exp2(), scaled.exact());
        }
    }
}

mod bytes {
    use bytemuck::{Pod, Zeroable, bytes_of, cast_slice, pod_read_unaligned};
    use sunglint::plain::{
        BasisQ14, BasisQ30, ColourQ16, ColourQ30, MaterialQ30, PointQ14, PointQ30, SoftShadow, SphereQ14, SphereQ30,
        VectorF32, VectorQ14, VectorQ30,
    };
    use sunglint::raw::{self, SUN_Q14, SUN_Q30};
    use sunglint::{DistantSphere, SUN};

    /// Any bits are one, and all of them are its.
    fn comes_back<T: Pod + PartialEq + std::fmt::Debug>() -> usize {
        let image: Vec<u8> = (1..=size_of::<T>() as u8).collect();
        let value: T = pod_read_unaligned(&image);
        assert_eq!(bytes_of(&value), image);
        assert_ne!(value, T::zeroed());
        size_of::<T>()
    }

    #[test]
    fn plain_structs_are_their_lanes() {
        let vectors = [comes_back::<VectorQ14>(), comes_back::<VectorQ30>(), comes_back::<VectorF32>()];
        let colours = [comes_back::<ColourQ16>(), comes_back::<ColourQ30>(), comes_back::<MaterialQ30>()];
        let points = [comes_back::<PointQ14>(), comes_back::<PointQ30>(), comes_back::<SoftShadow>()];
        let lights = [comes_back::<SphereQ14>(), comes_back::<SphereQ30>()];
        let bases = [comes_back::<BasisQ14>(), comes_back::<BasisQ30>()];
        assert_eq!((vectors, colours, points), ([6, 12, 12], [12, 12, 28], [4, 8, 8]));
        assert_eq!((lights, bases), ([16, 32], [12, 24]));
        assert_eq!(VectorQ14::zeroed(), VectorQ14::default());
    }

    #[test]
    fn a_light_goes_through_a_flash_image() {
        let (narrow, wide) = (SphereQ14::from(SUN_Q14), SphereQ30::from(SUN_Q30));
        let image = [bytes_of(&narrow), bytes_of(&wide)].concat();
        let again = (pod_read_unaligned::<SphereQ14>(&image[..16]), pod_read_unaligned::<SphereQ30>(&image[16..]));
        assert_eq!((raw::SphereQ14::from(again.0), raw::SphereQ30::from(again.1)), (SUN_Q14, SUN_Q30));
        assert_eq!(image[..16], *bytes_of(&SUN_Q14.to_array()));
        assert_eq!(image[16..], *bytes_of(&SUN_Q30.to_array()));
    }

    #[test]
    fn a_light_is_a_uniform() {
        const UNIFORM: [f32; 4] = DistantSphere::<f32>::new(&SUN).to_array();
        let light = DistantSphere::<f32>::of(&SUN);
        let lanes = [light.sin(), light.sin_square(), light.cos(), light.versine()];
        assert_eq!(cast_slice::<f32, u8>(&UNIFORM), lanes.map(f32::to_le_bytes).as_flattened());
    }
}

mod exchanged {
    use mint::{IntoMint, Vector3};
    use sunglint::plain::{VectorF32, VectorQ14, VectorQ30};
    use sunglint::{DistantSphere, SUN, cap, raw};

    #[test]
    fn vectors_keep_their_lanes() {
        let q14 = Vector3 { x: 1_i16, y: -2, z: 16_384 };
        assert_eq!(<[i16; 3]>::from(VectorQ14::from(q14)), [1, -2, 16_384]);
        assert_eq!(Vector3::from(VectorQ14 { x: 1, y: -2, z: 16_384 }), q14);
        let q30 = Vector3 { x: 1_i32, y: -2, z: 1 << 30 };
        assert_eq!(<[i32; 3]>::from(VectorQ30::from(q30)), [1, -2, 1 << 30]);
        assert_eq!(Vector3::from(VectorQ30 { x: 1, y: -2, z: 1 << 30 }), q30);
        let f32 = Vector3 { x: 1.5_f32, y: -2.0, z: 0.1 };
        assert_eq!(<[f32; 3]>::from(VectorF32::from(f32)), [1.5, -2.0, 0.1]);
        assert_eq!(Vector3::from(VectorF32 { x: 1.5, y: -2.0, z: 0.1 }), f32);
    }

    /// What takes any crate's vectors takes these.
    fn third<T>(v: impl IntoMint<MintType = Vector3<T>>) -> T {
        v.into().z
    }

    #[test]
    fn vectors_say_what_they_convert_into() {
        assert_eq!(third(VectorQ14 { x: 1, y: 2, z: 3 }), 3);
        assert_eq!(third(VectorQ30 { x: 1, y: 2, z: 3 }), 3);
        assert_eq!(third(VectorF32 { x: 1.0, y: 2.0, z: 3.0 }), 3.0);
    }

    /// Functions take arrays, which mint itself converts.
    #[test]
    fn functions_take_any_crates_vectors() {
        let (l, r) = (Vector3 { x: 0.0_f32, y: 0.6, z: 0.8 }, Vector3 { x: 0.0, y: 0.0, z: 1.0 });
        let shaded: Vector3<f32> = cap(l.into(), r.into(), &DistantSphere::<f32>::new(&SUN)).into();
        assert_eq!(<[f32; 3]>::from(shaded), cap([0.0, 0.6, 0.8], [0.0, 0.0, 1.0], &DistantSphere::<f32>::new(&SUN)));
        let up = VectorQ14::from(Vector3 { x: 0, y: 0, z: 16_384 });
        assert_eq!(raw::cap_q14(up.into(), up.into(), &raw::SUN_Q14), [0, 0, 16_384]);
    }
}
