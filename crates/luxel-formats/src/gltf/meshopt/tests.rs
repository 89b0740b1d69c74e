//! Streams from the extension's reference encoder (npm `meshoptimizer` 1.3.0), with the output of
//! its decoder.

use super::*;
use proptest::prelude::*;

const ATTRIBUTES: &str = "\
    a00000000a066666666666666666660000000000000a088888888888888888880000000000000a0aaaaa\
    aaaaaaaaaaaaaa00000000000007000b18feed101c6dbdab7ac1e7b7ffccff000000ae70cd7107009fa3\
    6c1df94914e31ebf3502ffe181ff0000004a60137b0527e66f66b0afacab7e000000b0af0527e66f66b0\
    afacab7e000000b0af0527e66f66b0afacab7e000000b0af0527e66f66b0afacab7e000000b0af000000\
    0000000000000000000000000000000000070707000000a74e03030303";
const ATTRIBUTES_UNPACKED: &str = "\
    070707000000a74e03030303070707030405a1fe0404040407070706080aadac03030303070707090c0f\
    2ce25b5b5b5b0707070c1014b5d3030303030707070f1419bd560404040407070712181ecb3103030303\
    070707151c23943b0404040407070718202835c9030303030707071b242ddfd8040404040707071e2832\
    1c785a5a5a5a070707212c37bb5d0404040407070724303c475e03030303070707273441ebde04040404\
    0707072a38466b6d030303030707072d3c4bd12c04040404070707304050285103030303070707334455\
    60815b5b5b5b07070736485af97703030303070707394c5fc03904040404";
const TRIANGLES: &str = "e1f0101000ff92ff16ff120101ff1a0202007687566778a9866589689801690000";
const TRIANGLES_UNPACKED: &str = "\
    000000000100000002000000020000000100000003000000030000000100000004000000030000000400\
    000005000000090000000800000007000000000000000200000009000000140000001500000016000000\
    160000001500000005000000";
const TRIANGLES16: &str = "e1f0101000ff92ff16ff120101ff1a0202007687566778a9866589689801690000";
const TRIANGLES16_UNPACKED: &str = "\
    000001000200020001000300030001000400030004000500090008000700000002000900140015001600\
    160015000500";
const SEQUENCE: &str = "d1000404b109030c9582110400000000";
const SEQUENCE_UNPACKED: &str = "0000000001000000020000002c0100002b010000050000007011010006000000";
const OCT8: &str = "\
    a0013fc00000fdfe62f4013fc00000fd6f266300013c000000fefd000000000000000000000000000000\
    000000000000000000000000007f007f00";
const OCT8_UNPACKED: &str = "7f0000000081007f4c009a00c451b30049494a00";
const OCT16: &str = "\
    a00127c0000007a1013fc000000d0e1910012fc00000dd6433013ec000000f180500000118000000013c\
    000000fefd000000000000000000000000000000000000000000000000ff070000ff070000";
const OCT16_UNPACKED: &str =
    "ff7f000000000000000001800000ff7fc54c00009599000097c2f35136b30000dd49dd49f9490000";
const QUAT: &str = "\
    a0013f000000fb7989013f000000b4c488013f000000fcc731013f000000b5dadc013f000000fb94ca01\
    3f000000b4fd46013f000000050403000000000000000000000000000000000000000000000000000000\
    00000000ff7f";
const QUAT_UNPACKED: &str = "000000000000ff7fff3f004000c00040cd0c67e632731bd07f5a00007ea5b9fe";
const EXP: &str = "\
    a00001300000001f00013c0000001e64013c000000902c013c000000c8210120000000013c0000001e64\
    0130000000070000013c0000001e640000000000000000000000000000000000000000001000f400d8ff\
    f4040000f4";
const EXP_UNPACKED: &str =
    "0000803f000020c00000803a000000000020f14700000000000000000078ad6000000000";

fn bytes_of(hex: &str) -> Vec<u8> {
    let digit = |byte: u8| char::from(byte).to_digit(16).unwrap() as u8;
    hex.as_bytes().chunks(2).map(|pair| digit(pair[0]) << 4 | digit(pair[1])).collect()
}

fn view(mode: &str, filter: Option<&str>, count: u64, stride: u64) -> Meshopt {
    Meshopt {
        buffer: 0,
        byte_offset: 0,
        byte_length: 0,
        byte_stride: stride,
        count,
        mode: mode.to_owned(),
        filter: filter.map(str::to_owned),
    }
}

/// A stream: mode, filter, count, stride, packed, unpacked.
type Stream = (&'static str, Option<&'static str>, u64, u64, &'static str, &'static str);

const STREAMS: &[Stream] = &[
    ("ATTRIBUTES", None, 20, 12, ATTRIBUTES, ATTRIBUTES_UNPACKED),
    ("TRIANGLES", None, 24, 4, TRIANGLES, TRIANGLES_UNPACKED),
    ("TRIANGLES", None, 24, 2, TRIANGLES16, TRIANGLES16_UNPACKED),
    ("INDICES", None, 8, 4, SEQUENCE, SEQUENCE_UNPACKED),
    ("ATTRIBUTES", Some("OCTAHEDRAL"), 5, 4, OCT8, OCT8_UNPACKED),
    ("ATTRIBUTES", Some("OCTAHEDRAL"), 5, 8, OCT16, OCT16_UNPACKED),
    ("ATTRIBUTES", Some("QUATERNION"), 4, 8, QUAT, QUAT_UNPACKED),
    ("ATTRIBUTES", Some("EXPONENTIAL"), 3, 12, EXP, EXP_UNPACKED),
];

#[test]
fn streams_unpack_as_the_reference_decoder_does() {
    for &(mode, filter, count, stride, packed, unpacked) in STREAMS {
        let bytes = decompress(&view(mode, filter, count, stride), &bytes_of(packed)).unwrap();
        assert_eq!(bytes, bytes_of(unpacked), "{mode} {filter:?}, stride {stride}");
    }
}

#[test]
fn streams_that_end_early_or_late_are_refused() {
    for &(mode, filter, count, stride, packed, _) in STREAMS {
        let view = view(mode, filter, count, stride);
        let packed = bytes_of(packed);
        for length in 0..packed.len() {
            assert!(decompress(&view, &packed[..length]).is_err(), "{mode}: {length} bytes");
        }
        let longer = [&packed[..1], &[0; 3], &packed[1..]].concat();
        assert!(decompress(&view, &longer).is_err(), "{mode}: three bytes more");
    }
}

#[test]
fn unknown_modes_filters_and_strides_are_refused() {
    let stream = bytes_of(ATTRIBUTES);
    for (mode, filter, stride) in [
        ("VERTICES", None, 12),
        ("ATTRIBUTES", Some("COLOR"), 12),
        ("ATTRIBUTES", Some("OCTAHEDRAL"), 12),
        ("ATTRIBUTES", None, 0),
        ("ATTRIBUTES", None, 10),
        ("ATTRIBUTES", None, 260),
        ("TRIANGLES", None, 12),
    ] {
        assert!(decompress(&view(mode, filter, 20, stride), &stream).is_err(), "{mode} {stride}");
    }
}

proptest! {
    #[test]
    fn any_bytes_end_in_data_of_the_right_length_or_an_error(
        stream in 0..STREAMS.len(),
        changes in proptest::collection::vec((any::<usize>(), any::<u8>()), 1..8),
        count in 0_u64..2000,
    ) {
        let (mode, filter, whole, stride, packed, _) = STREAMS[stream];
        let mut packed = bytes_of(packed);
        for (at, value) in changes {
            let at = at % packed.len();
            packed[at] = value;
        }
        for count in [whole, count] {
            if let Ok(bytes) = decompress(&view(mode, filter, count, stride), &packed) {
                prop_assert_eq!(bytes.len() as u64, count * stride);
            }
        }
    }
}
