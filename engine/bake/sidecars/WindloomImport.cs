// Sets the import settings of the wind images beside it: numbers, not colours. Files in other folders are left alone.
#if UNITY_EDITOR
using System.IO;
using System.Runtime.CompilerServices;
using UnityEditor;
using UnityEngine;

public class WindloomImport_@IDENTIFIER@ : AssetPostprocessor
{
    void OnPreprocessTexture()
    {
        if (Path.GetFullPath(Path.GetDirectoryName(assetPath)) != Path.GetFullPath(Path.GetDirectoryName(Here()))) return;
        if (!IsOurs(Path.GetFileName(assetPath))) return;
        var importer = (TextureImporter)assetImporter;
        importer.sRGBTexture = false;
        importer.mipmapEnabled = false;
        importer.npotScale = TextureImporterNPOTScale.None;
        importer.wrapModeU = TextureWrapMode.@WRAP_A@;
        importer.wrapModeV = TextureWrapMode.@WRAP_B@;
        importer.filterMode = FilterMode.Bilinear;
        importer.textureCompression = TextureImporterCompression.Uncompressed;
        importer.maxTextureSize = 16384;
@if HAS_ATLAS
        if (assetPath.EndsWith("flow-atlas.png"))
        {
            var shape = new TextureImporterSettings();
            importer.ReadTextureSettings(shape);
            shape.textureShape = TextureImporterShape.Texture2DArray;
            shape.flipbookColumns = @TILES_A@;
            shape.flipbookRows = @TILES_B@;
            importer.SetTextureSettings(shape);
        }
@end
        bool isFloat = assetPath.EndsWith(".exr");
        if (!isFloat && !Path.GetFileName(assetPath).Contains("flow16.")) return;
        TextureImporterPlatformSettings settings = importer.GetDefaultPlatformTextureSettings();
        settings.format = isFloat ? TextureImporterFormat.RGBAHalf : TextureImporterFormat.RGBA64;
        settings.maxTextureSize = 16384;
        importer.SetPlatformTextureSettings(settings);
    }

    static string Here([CallerFilePath] string path = "")
    {
        return path;
    }

    static bool IsOurs(string name)
    {
        return @FILE_TEST@;
    }
}
#endif
